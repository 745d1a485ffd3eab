#pragma once
#include <vector>

#include "model/film.hpp"

namespace arenite::thermography {

/// Times of all frames, s after the first: its stamps, so that dropped frames leave a gap, or number over frame rate
/// where frames are not stamped. `frame_rate` (Hz) above 0 is used where the film says neither. Throws InputError where
/// there is no rate at all or stamps do not rise.
std::vector<double> frame_times(const FilmInfo& film, double frame_rate = 0);

/// From the beginning of the first frame to the end of the last, s.
double film_length(const std::vector<double>& time);

/// Half the rate of frames where they follow each other without a gap, Hz.
double nyquist_frequency(const std::vector<double>& time);

}  // namespace arenite::thermography
