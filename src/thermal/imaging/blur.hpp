#pragma once
#include <vector>

#include "model/image.hpp"

namespace arenite::imaging {

/// Convolution with a Gaussian of this standard deviation in pixels; pixels beyond the edge repeat the edge.
FloatImage blurred(const FloatImage& image, double sigma);

/// Mean of every two by two pixels; an odd last row or column is left out. Pixel (c, r) lies at (2c + 0.5, 2r + 0.5).
FloatImage halved(const FloatImage& image);

/// Standard deviation of the noise from pixel to pixel: the median size of a second difference that is blind to slopes
/// in x and y, so edges count as little as they are rare.
double noise_level(const FloatImage& image);

/// Pixels first .. last of a row.
struct Run {
  int y, first, last;
};

/// Pixels that are open (not 0).
using Mask = Picture<char>;

/// The open pixels and those beside them, row by row.
std::vector<Run> runs_of(const Mask& open);

/// Open pixels of a picture halved, with those beside them, since a centre may yet move by a pixel.
Mask halved_open(const Mask& open);

}  // namespace arenite::imaging
