#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace arenite {

/// A grey picture, or one of labels: whole numbers row by row from the top left, as pictures are stored.
struct Image {
  int width = 0, height = 0;        ///< pixels
  std::vector<std::int32_t> value;  ///< one a pixel, index x + width row

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t index(int x, int row) const { return static_cast<std::size_t>(x) + static_cast<std::size_t>(width) * static_cast<std::size_t>(row); }
};

/// The same with fractions: a frame's mean, a map of amplitudes.
struct FloatImage {
  int width = 0, height = 0;  ///< pixels
  std::vector<float> value;   ///< one a pixel, index x + width row

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t index(int x, int row) const { return static_cast<std::size_t>(x) + static_cast<std::size_t>(width) * static_cast<std::size_t>(row); }
};

/// Whole numbers as fractions; exact up to 2^24.
inline FloatImage to_float(const Image& image) { return {image.width, image.height, std::vector<float>(image.value.begin(), image.value.end())}; }

/// Grains found in a picture, in pixels: the centre of the pixel in column c and row r (from the top) is at x = c, y = r.
struct PictureGrains {
  std::vector<double> x, y, radius;      ///< pixels
  std::vector<double> position_error;    ///< standard error of the centre along one axis, pixels
  std::vector<double> radius_error;      ///< pixels
  std::vector<double> brightness;        ///< mean over the inner half of the disk
  std::vector<double> score;             ///< share of the rim that shows an edge, 0 to 1
  std::vector<std::int32_t> material;    ///< index into the classes by brightness, darkest first; -1 unknown
  std::vector<std::int32_t> size_class;  ///< index into the classes of radius, smallest first
  std::size_t size() const { return x.size(); }
};

}  // namespace arenite
