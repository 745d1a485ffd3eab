#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "solid/peridynamics/kernels/kernels.hpp"

namespace arenite::peridynamics {

/// A symmetric 2 x 2 stiffness, Pa.
struct Block {
  double xx = 0, xy = 0, yy = 0;
  friend Block operator+(Block a, Block b) { return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy}; }
};

/// Stiffness of a bond by its direction and type.
using BondBlocks = std::array<std::array<Block, 4>, bonds_per_node>;
BondBlocks bond_blocks(const Bonds& bonds);

/// Symmetric 2 x 2 stiffness of every node against its neighbours held fast, Pa, or the inverse of it. Padded. The
/// coarse matrix needs it in double: rounded to single it would outweigh the bonds and cost the sum its definiteness.
template <class T> struct BlockDiagonal {
  Buffer<T> xx, xy, yy;
  explicit BlockDiagonal(std::size_t n) : xx(n), xy(n), yy(n) {}
  void set(std::ptrdiff_t i, Block b) {
    xx[i] = static_cast<T>(b.xx), xy[i] = static_cast<T>(b.xy), yy[i] = static_cast<T>(b.yy);
  }
};

BlockDiagonal<double> block_diagonal(const Bonds& bonds);

/// Inverse blocks; prescribed components are left out, and directions that no bond resists get the pseudo-inverse.
/// `loose` counts the nodes, not void, that can move freely in some direction: ends of hinged chains.
struct InverseDiagonal {
  BlockDiagonal<float> blocks;
  std::size_t loose = 0;
  BlockPlane plane() const { return {blocks.xx.data(), blocks.xy.data(), blocks.yy.data()}; }
};
InverseDiagonal inverse_diagonal(const Bonds& bonds, const BlockDiagonal<double>& diagonal,
                                 const std::vector<std::uint8_t>& prescribed);

}  // namespace arenite::peridynamics
