#pragma once
#include <filesystem>

#include "model/film_result.hpp"

namespace arenite::io {

/// Writes what a film gave as one HDF5 file, all or nothing. /maps holds arrays of height x width pixels, the top row
/// first, in kelvin; /grains, /swing and /forces arrays as long as the grains or contacts of /packing.
void write_film_result(const std::filesystem::path& path, const FilmResult& result);

/// Reads it back. Throws InputError for a file that is missing, foreign, newer, cut short (DamagedFile) or damaged.
FilmResult read_film_result(const std::filesystem::path& path);

}  // namespace arenite::io
