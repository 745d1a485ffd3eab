#pragma once
#include <vector>

/// What light meets on its way, for cameras that are drawn and films that are measured alike.
namespace arenite::optics {

/// What a lens' Gaussian blur and the mean over a pixel make of a scene drawn on points finer than the pixels; alike and
/// apart along both axes.
struct Lens {
  int fine = 1;             ///< points along a side of a pixel
  int margin = 0;           ///< points beyond the picture, on each side, that the blur brings in
  std::vector<float> taps;  ///< shares of the points that a pixel sees along one axis, from `margin` before its first; sum 1
};

/// `blur` is the Gaussian's standard deviation in pixels, cut off beyond `reach` of these.
Lens make_lens(double blur, int fine, double reach);

/// The picture that is seen, width x height, of a scene of (width fine + 2 margin) x (height fine + 2 margin) points, both
/// row by row from the top.
std::vector<float> through_lens(const Lens& lens, const std::vector<float>& scene, int width, int height);

}  // namespace arenite::optics
