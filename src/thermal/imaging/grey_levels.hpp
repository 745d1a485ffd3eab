#pragma once
#include <vector>

#include "model/image.hpp"

namespace arenite::imaging {

/// Grey levels that a picture's pixels gather at, with others on both sides: what is between black and white grains may be
/// one of them. Peaks of the smoothed histogram that hold 1 % of the pixels and fall to half before the next; the fullest
/// first, the darkest and the brightest of all left out. None where there are fewer than three.
std::vector<double> levels_between(const FloatImage& image);

}  // namespace arenite::imaging
