#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/pages.hpp"
#include "solid/statics/grid.hpp"
#include "solid/statics/pool.hpp"

namespace arenite::statics {

/// The components of something symmetric.
template <int D, class V> struct Symmetric;
template <class V> struct Symmetric<2, V> {
  V xx{}, xy{}, yy{};
  static constexpr int count = 3;
  constexpr V& operator()(int a, int b) { return a != b ? xy : a == 0 ? xx : yy; }
  constexpr const V& operator()(int a, int b) const { return a != b ? xy : a == 0 ? xx : yy; }
};
template <class V> struct Symmetric<3, V> {
  V xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
  static constexpr int count = 6;
  constexpr V& operator()(int a, int b) {
    if (a == b) return a == 0 ? xx : a == 1 ? yy : zz;
    return a + b == 1 ? xy : a + b == 2 ? xz : yz;
  }
  constexpr const V& operator()(int a, int b) const { return const_cast<Symmetric&>(*this)(a, b); }
};

/// A symmetric stiffness, Pa in the plane and N/m in space.
template <int D> using BlockIn = Symmetric<D, double>;
using Block = BlockIn<2>;
inline Block operator+(Block a, Block b) { return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy}; }

/// Symmetric block of every node, the inverse of its diagonal stiffness.
template <int D> using BlockPointers = Symmetric<D, const float*>;
using BlockPlane = BlockPointers<2>;

/// Symmetric stiffness of every node against its neighbours held fast, or the inverse of it. Padded. The coarse matrix
/// needs it in double: rounded to single it would outweigh what joins the nodes and cost the sum its definiteness.
template <int D, class T> struct BlockDiagonalIn : Symmetric<D, Buffer<T>> {
  explicit BlockDiagonalIn(std::size_t n) {
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) (*this)(a, b) = Buffer<T>(n);
  }
  void set(std::ptrdiff_t i, BlockIn<D> block) {
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) (*this)(a, b)[i] = static_cast<T>(block(a, b));
  }
  BlockIn<D> at(std::ptrdiff_t i) const {
    BlockIn<D> block;
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) block(a, b) = static_cast<double>((*this)(a, b)[i]);
    return block;
  }
};
template <class T> using BlockDiagonal = BlockDiagonalIn<2, T>;

/// Inverse blocks; prescribed components are left out, and directions that nothing resists get the pseudo-inverse (in
/// space: nothing). `loose` counts the nodes, not void, that can move freely in some direction: ends of hinged chains.
template <int D> struct InverseDiagonalIn {
  BlockDiagonalIn<D, float> blocks;
  std::size_t loose = 0;
  BlockPointers<D> pointers() const {
    BlockPointers<D> p;
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) p(a, b) = blocks(a, b).data();
    return p;
  }
};
using InverseDiagonal = InverseDiagonalIn<2>;

/// Of the block that `diagonal` gives for a node; `prescribed` has one entry a level of the grid.
template <int D>
InverseDiagonalIn<D> inverse_diagonal(const Grid& grid, const std::function<BlockIn<D>(std::ptrdiff_t)>& diagonal,
                                      const std::vector<std::uint8_t>& prescribed, const ThreadPool* pool = nullptr);
template <int D>
InverseDiagonalIn<D> inverse_diagonal(const Grid& grid, const BlockDiagonalIn<D, double>& diagonal,
                                      const std::vector<std::uint8_t>& prescribed) {
  return inverse_diagonal<D>(
      grid, std::function<BlockIn<D>(std::ptrdiff_t)>([&](std::ptrdiff_t i) { return diagonal.at(i); }), prescribed);
}
extern template InverseDiagonalIn<2> inverse_diagonal(const Grid&, const std::function<Block(std::ptrdiff_t)>&,
                                                      const std::vector<std::uint8_t>&, const ThreadPool*);
extern template InverseDiagonalIn<3> inverse_diagonal(const Grid&, const std::function<BlockIn<3>(std::ptrdiff_t)>&,
                                                      const std::vector<std::uint8_t>&, const ThreadPool*);

}  // namespace arenite::statics
