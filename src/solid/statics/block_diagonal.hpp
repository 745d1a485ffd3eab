#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/pages.hpp"
#include "solid/statics/grid.hpp"

namespace arenite::statics {

/// A symmetric 2 x 2 stiffness, Pa.
struct Block {
  double xx = 0, xy = 0, yy = 0;
  friend Block operator+(Block a, Block b) { return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy}; }
};

/// Symmetric 2 x 2 block of a node, the inverse of its diagonal stiffness.
struct BlockPlane {
  const float *xx, *xy, *yy;
};

/// Symmetric 2 x 2 stiffness of every node against its neighbours held fast, Pa, or the inverse of it. Padded. The
/// coarse matrix needs it in double: rounded to single it would outweigh what joins the nodes and cost the sum its
/// definiteness.
template <class T> struct BlockDiagonal {
  Buffer<T> xx, xy, yy;
  explicit BlockDiagonal(std::size_t n) : xx(n), xy(n), yy(n) {}
  void set(std::ptrdiff_t i, Block b) {
    xx[i] = static_cast<T>(b.xx), xy[i] = static_cast<T>(b.xy), yy[i] = static_cast<T>(b.yy);
  }
};

/// Inverse blocks; prescribed components are left out, and directions that nothing resists get the pseudo-inverse.
/// `loose` counts the nodes, not void, that can move freely in some direction: ends of hinged chains.
struct InverseDiagonal {
  BlockDiagonal<float> blocks;
  std::size_t loose = 0;
  BlockPlane plane() const { return {blocks.xx.data(), blocks.xy.data(), blocks.yy.data()}; }
};
InverseDiagonal inverse_diagonal(const Grid& grid, const BlockDiagonal<double>& diagonal,
                                 const std::vector<std::uint8_t>& prescribed);

}  // namespace arenite::statics
