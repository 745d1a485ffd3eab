#pragma once
#include <cstddef>

namespace arenite::peridynamics {

/// How a raster lies in memory while it is worked on: rows padded with empty nodes by at least a horizon on every side,
/// so that no loop asks where the sample ends, and to whole vectors of 16 nodes, so that loops run in full lanes.
struct Grid {
  static constexpr int lanes = 8;   ///< nodes of a group
  static constexpr int vector = 16;  ///< nodes of the widest vector
  int width = 0, height = 0;        ///< nodes of the sample
  int groups = 0;                   ///< groups of 8 nodes a row
  std::ptrdiff_t stride = 0;        ///< nodes from one row to the next

  Grid() = default;
  Grid(int w, int h) : width(w), height(h), groups((w + lanes - 1) / lanes), stride(row_vectors() * vector + vector) {
    if (stride % 128 == 0) stride += vector;  // rows a power of two apart share cache sets
  }
  int row_vectors() const { return (width + vector - 1) / vector; }
  std::ptrdiff_t row(int y) const { return (y + 3) * stride + vector; }
  std::ptrdiff_t index(int x, int y) const { return row(y) + x; }
  std::size_t padded_size() const { return static_cast<std::size_t>((height + 6) * stride + 3 * vector); }
};

}  // namespace arenite::peridynamics
