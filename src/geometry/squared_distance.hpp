#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace arenite::geometry {

/// Equal cells in the plane (one layer) or in space: cell (x, y, z) has index x + width (y + height z).
struct Cells {
  int width = 1, height = 1, depth = 1;
  bool periodic = false;  ///< they repeat themselves along all axes

  std::array<int, 3> count() const { return {width, height, depth}; }
  std::array<std::size_t, 3> stride() const {
    const auto row = static_cast<std::size_t>(width);
    return {1, row, row * static_cast<std::size_t>(height)};
  }
  std::size_t size() const { return stride()[2] * static_cast<std::size_t>(depth); }
};

/// Squared distance, in cells, from each cell that is inside to the nearest that is not; 0 where it is not. Exact
/// (A. Meijster, J. Roerdink, W. Hesselink, 2000). What lies beyond cells that are not periodic is not known and does
/// not count; where all are inside each has the largest number.
std::vector<std::int32_t> squared_distance(const Cells& cells, const std::vector<std::uint8_t>& inside);

}  // namespace arenite::geometry
