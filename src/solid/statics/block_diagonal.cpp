#include "solid/statics/block_diagonal.hpp"

namespace arenite::statics {

namespace {

Block inverse_of(Block b, std::uint8_t prescribed, bool& loose) {
  if (prescribed == both_prescribed) return {0, 0, 0};
  if (prescribed & x_prescribed) return {0, 0, b.yy > 0 ? 1 / b.yy : 0};
  if (prescribed & y_prescribed) return {b.xx > 0 ? 1 / b.xx : 0, 0, 0};
  const double trace = b.xx + b.yy, determinant = b.xx * b.yy - b.xy * b.xy;
  if (determinant > 1e-9 * trace * trace) return {b.yy / determinant, -b.xy / determinant, b.xx / determinant};
  loose = true;
  if (!(trace > 0)) return {0, 0, 0};
  const double s = 1 / (trace * trace);  // rank one: B/trace^2 is its pseudo-inverse
  return {s * b.xx, s * b.xy, s * b.yy};
}

BlockIn<3> inverse_of(BlockIn<3> b, std::uint8_t prescribed, bool& loose) {
  for (int a = 0; a < 3; ++a)
    if (prescribed >> a & 1)
      for (int c = 0; c < 3; ++c) b(a, c) = a == c ? 1 : 0;
  BlockIn<3> cofactor;
  for (int a = 0; a < 3; ++a)
    for (int c = a; c < 3; ++c) {
      const int a1 = (a + 1) % 3, a2 = (a + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
      cofactor(a, c) = b(a1, c1) * b(a2, c2) - b(a1, c2) * b(a2, c1);
    }
  const double determinant = b.xx * cofactor.xx + b.xy * cofactor.xy + b.xz * cofactor.xz;
  loose = !(determinant > 1e-9 * b.xx * b.yy * b.zz);
  for (int a = 0; a < 3; ++a)
    for (int c = a; c < 3; ++c) {
      const bool held = prescribed >> a & 1 || prescribed >> c & 1;
      cofactor(a, c) = loose || held ? 0 : cofactor(a, c) / determinant;
    }
  return cofactor;
}

bool has_stiffness(const Block& b) { return b.xx + b.yy > 0; }
bool has_stiffness(const BlockIn<3>& b) { return b.xx + b.yy + b.zz > 0; }

}  // namespace

template <int D>
InverseDiagonalIn<D> inverse_diagonal(const Grid& grid, const std::function<BlockIn<D>(std::ptrdiff_t)>& diagonal,
                                      const std::vector<std::uint8_t>& prescribed, const ThreadPool* pool) {
  InverseDiagonalIn<D> inverse{BlockDiagonalIn<D, float>(grid.padded_size())};
  std::vector<std::size_t> loose_at(static_cast<std::size_t>(grid.levels()), 0);
  each_node(pool, grid, [&](std::ptrdiff_t i, int level) {
    const BlockIn<D> own = diagonal(i);
    if (!has_stiffness(own)) return;
    bool loose = false;
    inverse.blocks.set(i, inverse_of(own, prescribed[static_cast<std::size_t>(level)], loose));
    loose_at[static_cast<std::size_t>(level)] += loose;
  });
  for (const std::size_t count : loose_at) inverse.loose += count;
  return inverse;
}

template InverseDiagonalIn<2> inverse_diagonal(const Grid&, const std::function<Block(std::ptrdiff_t)>&,
                                               const std::vector<std::uint8_t>&, const ThreadPool*);
template InverseDiagonalIn<3> inverse_diagonal(const Grid&, const std::function<BlockIn<3>(std::ptrdiff_t)>&,
                                               const std::vector<std::uint8_t>&, const ThreadPool*);

}  // namespace arenite::statics
