#pragma once
#include <algorithm>
#include <cstddef>

#include "solid/statics/grid.hpp"

namespace arenite::statics {

/// Copies, in a periodic grid, to the empty nodes around the sample what the opposite side has: one node wide, edges
/// and corners too. In other grids nothing happens.
template <class T> void close_period(const Grid& grid, T* at) {
  if (!grid.periodic) return;
  for (int z = 0; z < grid.depth; ++z) {
    for (int y = 0; y < grid.height; ++y) {
      T* const row = at + grid.row(y, z);
      row[-1] = row[grid.width - 1];
      row[grid.width] = row[0];
    }
    const std::ptrdiff_t whole = grid.width + 2;
    std::copy_n(at + grid.row(grid.height - 1, z) - 1, whole, at + grid.row(-1, z) - 1);
    std::copy_n(at + grid.row(0, z) - 1, whole, at + grid.row(grid.height, z) - 1);
  }
  if (!grid.in_space()) return;
  const std::ptrdiff_t whole = (grid.height + 1) * grid.stride + grid.width + 2;
  std::copy_n(at + grid.row(-1, grid.depth - 1) - 1, whole, at + grid.row(-1, -1) - 1);
  std::copy_n(at + grid.row(-1, 0) - 1, whole, at + grid.row(-1, grid.depth) - 1);
}
template <int D, class T> void close_period(const Grid& grid, FieldIn<D, T>& field) {
  for (int c = 0; c < D; ++c) close_period(grid, field[c].data());
}

}  // namespace arenite::statics
