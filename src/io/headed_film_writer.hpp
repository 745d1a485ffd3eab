#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

#include "io/film_writers.hpp"

namespace arenite::io {

/// Writes one header and then the frames as they lie in memory. The header says how many frames there are, which is
/// known at the end, so it is written again then and must be as long for any number.
FilmWriterPointer create_headed_film(const std::filesystem::path& path, const FilmInfo& info, std::string (*header)(const FilmInfo&, std::size_t frames));

}  // namespace arenite::io
