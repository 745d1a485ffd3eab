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
  std::size_t index(int x, int row) const {
    return static_cast<std::size_t>(x) + static_cast<std::size_t>(width) * static_cast<std::size_t>(row);
  }
};

/// The same with fractions: a frame's mean, a map of amplitudes.
struct FloatImage {
  int width = 0, height = 0;  ///< pixels
  std::vector<float> value;   ///< one a pixel, index x + width row

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t index(int x, int row) const {
    return static_cast<std::size_t>(x) + static_cast<std::size_t>(width) * static_cast<std::size_t>(row);
  }
};

/// Whole numbers as fractions; exact up to 2^24.
inline FloatImage to_float(const Image& image) {
  return {image.width, image.height, std::vector<float>(image.value.begin(), image.value.end())};
}

}  // namespace arenite
