#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.hpp"

namespace arenite {

/// A picture: one value a pixel, row by row from the top left, as pictures are stored.
template <class T> struct Picture {
  int width = 0, height = 0;  ///< pixels
  std::vector<T> value;       ///< index x + width row

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t index(int x, int row) const {
    return static_cast<std::size_t>(x) + static_cast<std::size_t>(width) * static_cast<std::size_t>(row);
  }
};
using Image = Picture<std::int32_t>;  ///< grey, or of labels
using FloatImage = Picture<float>;    ///< with fractions: a frame's mean, a map of amplitudes

/// Calls visit(column, row, index) for the pixels of a picture whose centres are no farther from `place` than `reach`
/// along each axis, row by row.
template <class Visit> void each_pixel_near(Vec2 place, double reach, int width, int height, Visit&& visit) {
  const auto first = [](double v, int n) { return static_cast<int>(std::ceil(std::clamp<double>(v, 0, n))); };
  const auto last = [](double v, int n) { return static_cast<int>(std::floor(std::clamp<double>(v, -1, n - 1))); };
  for (int row = first(place.y - reach, height); row <= last(place.y + reach, height); ++row)
    for (int column = first(place.x - reach, width); column <= last(place.x + reach, width); ++column)
      visit(column, row,
            static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column));
}

/// Whole numbers as fractions; exact up to 2^24.
inline FloatImage to_float(const Image& image) {
  return {image.width, image.height, std::vector<float>(image.value.begin(), image.value.end())};
}

/// Grains found in a picture, in pixels: the centre of the pixel in column c and row r (from the top) is at x = c, y =
/// r.
struct PictureGrains {
  std::vector<Vec2> centre;              ///< pixels
  std::vector<double> radius;            ///< pixels
  std::vector<double> position_error;    ///< standard error of the centre along one axis, pixels
  std::vector<double> radius_error;      ///< pixels
  std::vector<double> brightness;        ///< mean over the inner half of the disk
  std::vector<double> score;             ///< share of the rim that shows an edge, 0 to 1
  std::vector<std::int32_t> material;    ///< index into the classes by brightness, darkest first; -1 unknown
  std::vector<std::int32_t> size_class;  ///< index into the classes of radius, smallest first
  std::size_t size() const { return centre.size(); }
};

}  // namespace arenite
