#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/problems.hpp"
#include "io/sample/formats.hpp"

namespace arenite::io {

/// Gives a packing its materials, in the order in which grains name them first, and every grain its material. `file`
/// is a table with a column material (as the grains write it) and any of name, density, stiffness,
/// thermoelastic_factor; its order then is the materials' order. Or it has columns id and material, for grains whose
/// file has no material. Grains that have none where others do are told in a note.
void assign_materials(const RawGrains& raw, const std::optional<std::filesystem::path>& file, Materials& materials,
                      std::vector<std::int32_t>& of_grain, std::vector<std::string>& notes, Problems& problems);

}  // namespace arenite::io
