#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "model/sphere_pack.hpp"

namespace arenite::io {

/// Whether a file is a table of spheres: of comma-separated values (.csv), or another program's (io/sample/).
bool is_sphere_table(const std::filesystem::path& path);

/// The spheres of anybody's table, as `arenite measure` reads it: in the periodic box that it states, else in the
/// smallest box that holds them all. Throws InputError with every bad row.
SpherePack read_spheres(const std::filesystem::path& path, std::vector<std::string>& notes);

}  // namespace arenite::io
