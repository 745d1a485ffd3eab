#pragma once
#include <span>
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

/// Where values are needed: at the open pixels (not 0) and beside them; all rows where `open` is empty.
std::vector<Run> runs_of(std::span<const char> open, int width, int height);

/// Open pixels of a picture halved, with those beside them, since a centre may yet move by a pixel.
std::vector<char> halved_open(std::span<const char> open, int width, int height);

}  // namespace arenite::imaging
