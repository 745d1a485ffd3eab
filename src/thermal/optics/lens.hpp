#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/vec.hpp"

/// What light meets on its way, for cameras that are drawn and films that are measured alike.
namespace arenite::optics {

/// What a lens' Gaussian blur and the mean over a pixel make of a scene drawn on points finer than the pixels; alike
/// and apart along both axes.
struct Lens {
  int fine = 1;    ///< points along a side of a pixel
  int margin = 0;  ///< points beyond the picture, on each side, that the blur brings in
  std::vector<float>
      taps;  ///< shares of the points that a pixel sees along one axis, from `margin` before its first; sum 1
};

/// `blur` is the Gaussian's standard deviation in pixels, cut off beyond `reach` of these.
Lens make_lens(double blur, int fine, double reach);

/// A scene on points finer than the pixels of a picture, and beyond it by what the lens brings in; row by row from the
/// top.
struct Canvas {
  int width, height;  ///< points
  Vec2 first, step;   ///< place of the first point, and from one to the next along a row and down the rows
  std::vector<float> light;

  /// For a picture of so many pixels whose middle is there.
  Canvas(const Lens& lens, int pixels_across, int pixels_down, Vec2 middle, Vec2 from_point_to_point);

  Vec2 place(int column, int row) const { return {first.x + column * step.x, first.y + row * step.y}; }

  /// Calls visit(index, offset from the centre) for the points in a disk.
  template <class Visit> void each_point(Vec2 centre, double radius, const Visit& visit) const {
    const auto [top, bottom] = near((centre.y - first.y) / step.y, radius / std::abs(step.y), height);
    for (int row = top; row < bottom; ++row) {
      const double dy = place(0, row).y - centre.y, half = std::sqrt(std::max(0.0, radius * radius - dy * dy));
      const auto [left, right] = near((centre.x - first.x) / step.x, half / step.x, width);
      for (int column = left; column < right; ++column)
        visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column),
              place(column, row) - centre);
    }
  }

 private:
  /// The first of `count` points that are no farther than `reach` from a place, and the end.
  static std::pair<int, int> near(double place, double reach, int count) {
    const auto clamped = [count](double v) { return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(count))); };
    return {clamped(std::ceil(place - reach)), clamped(std::floor(place + reach) + 1)};
  }
};

/// The picture that is seen, width x height, of a scene of (width fine + 2 margin) x (height fine + 2 margin) points,
/// both row by row from the top.
std::vector<float> through_lens(const Lens& lens, const std::vector<float>& scene, int width, int height);

}  // namespace arenite::optics
