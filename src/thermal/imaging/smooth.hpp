#pragma once
#include "model/image.hpp"

namespace arenite::imaging {

/// Convolution with a Gaussian of this standard deviation in pixels; pixels beyond the edge repeat the edge.
FloatImage blurred(const FloatImage& image, double sigma);

/// Mean of every two by two pixels; an odd last row or column is left out. Pixel (c, r) lies at (2c + 0.5, 2r + 0.5).
FloatImage halved(const FloatImage& image);

/// Value between pixels, linear in x and in y; beyond the edge that of the edge.
double sampled(const FloatImage& image, double x, double y);

/// Standard deviation of the noise from pixel to pixel: the median size of a second difference that is blind to slopes
/// in x and y, so edges count as little as they are rare.
double noise_level(const FloatImage& image);

}  // namespace arenite::imaging
