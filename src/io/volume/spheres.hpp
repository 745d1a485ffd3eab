#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "model/sphere_pack.hpp"

namespace arenite::io {

/// Whether a file is a table of spheres: of comma-separated values (.csv), or LBPM's pack.out.
bool is_sphere_table(const std::filesystem::path& path);

/// Spheres from a table with columns x, y, z and radius or diameter ("radius [mm]"; m where no unit is named), in the
/// smallest box that holds them all; or LBPM's, in the periodic box that it states. Throws InputError with every bad
/// row.
SpherePack read_spheres(const std::filesystem::path& path, std::vector<std::string>& notes);

}  // namespace arenite::io
