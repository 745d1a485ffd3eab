#pragma once
#include <memory>
#include <optional>

#include "arguments.hpp"
#include "model/film.hpp"

namespace arenite::python {

/// A film of a file, or of an array, which is looked at and not copied. `frame_rate` (Hz, 0: as the film says) and
/// `time` (s, one a frame) tell when frames were taken.
std::unique_ptr<FilmSource> film_of(const FilmLike& film, double frame_rate = 0,
                                    const std::optional<ArrayLike>& time = std::nullopt);

}  // namespace arenite::python
