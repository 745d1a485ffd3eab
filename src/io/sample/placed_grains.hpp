#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "model/packing.hpp"

namespace arenite::io {

/// Grains to start a simulation from, as a laboratory gives them: a table with columns id, x, y, radius (or diameter)
/// and material; lengths in m unless the header names a unit. Centres count from the container's lower left corner. Of
/// several moments in the table it is the last; that and whatever else was taken for granted goes to the notes. Throws
/// InputError with every problem found: unknown material, a grain outside the container, an id that occurs twice, a
/// file of another format.
Grains read_placed_grains(const std::filesystem::path& path, const Materials& materials, const Domain& domain,
                          std::vector<std::string>& notes);

}  // namespace arenite::io
