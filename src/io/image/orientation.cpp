#include "io/image/orientation.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace arenite::io {
namespace {

std::uint32_t number_in(std::string_view bytes, std::size_t at, std::size_t size, bool big_endian) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size && at + i < bytes.size(); ++i)
    value |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << 8 * (big_endian ? size - 1 - i : i);
  return value;
}

}  // namespace

Image upright(Image stored, int orientation) {
  if (orientation <= 1 || orientation > 8) return stored;
  const bool turned = orientation >= 5;
  Image seen{turned ? stored.height : stored.width, turned ? stored.width : stored.height, {}};
  seen.value.reserve(stored.size());
  const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const bool from_bottom = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  for (int row = 0; row < seen.height; ++row)
    for (int column = 0; column < seen.width; ++column) {
      const int x = turned ? row : column, y = turned ? column : row;
      seen.value.push_back(
          stored.value[stored.index(from_right ? stored.width - 1 - x : x, from_bottom ? stored.height - 1 - y : y)]);
    }
  return seen;
}

int exif_orientation(std::string_view exif) {
  constexpr std::size_t entry = 12;
  constexpr std::uint32_t tag = 0x0112;
  const bool big_endian = exif.starts_with("MM");
  if (!big_endian && !exif.starts_with("II")) return 1;
  const std::size_t directory = number_in(exif, 4, 4, big_endian), count = number_in(exif, directory, 2, big_endian);
  for (std::size_t k = 0; k < count && directory + 2 + (k + 1) * entry <= exif.size(); ++k) {
    const std::size_t at = directory + 2 + k * entry;
    if (number_in(exif, at, 2, big_endian) == tag) return static_cast<int>(number_in(exif, at + 8, 2, big_endian));
  }
  return 1;
}

}  // namespace arenite::io
