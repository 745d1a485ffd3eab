#pragma once
#include <cstddef>
#include <string>

#include "model/film_result.hpp"

namespace arenite::report {

/// A film in a few numbers: size, times and missing frames, what the camera says, levels and noise of the first frames,
/// up to `most_frames` of them.
Numbers film_summary(FilmSource& film, std::size_t most_frames = 64);

/// What a film gave, as a table for people and as JSON for programs.
std::string film_text(const FilmResult& result);
Numbers film_numbers(const FilmResult& result);

}  // namespace arenite::report
