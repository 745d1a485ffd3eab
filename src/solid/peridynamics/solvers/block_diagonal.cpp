#include <cmath>

#include "solid/peridynamics/solvers/block_diagonal.hpp"

namespace arenite::peridynamics {

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

}  // namespace

BondBlocks bond_blocks(const Bonds& bonds) {
  BondBlocks blocks{};
  for (unsigned d = 0; d < bonds_per_node; ++d)
    for (unsigned t = 1; t < 4; ++t) {
      const Offset e = half_bonds[d];
      const double k = bonds.modulus(t) / std::pow(length(e), 3);
      blocks[d][t] = {k * e.x * e.x, k * e.x * e.y, k * e.y * e.y};
    }
  return blocks;
}

BlockDiagonal<double> block_diagonal(const Bonds& bonds) {
  const Grid& grid = bonds.grid;
  BlockDiagonal<double> sum(grid.padded_size());
  const auto blocks = bond_blocks(bonds);
  std::array<Block, 4> bulk{};
  for (unsigned d = 0; d < bonds_per_node; ++d)
    for (unsigned t = 1; t < 4; ++t) bulk[t] = bulk[t] + (blocks[d][t] + blocks[d][t]);
  for (int y = 0; y < grid.height; ++y)
    for (int g = 0; g < grid.groups; ++g) {
      const auto kind = bonds.group[static_cast<std::ptrdiff_t>(y) * grid.groups + g];
      if (kind == Bonds::empty) continue;
      for (std::ptrdiff_t i = grid.row(y) + g * Grid::lanes, end = i + Grid::lanes; i < end; ++i) {
        Block b = kind == Bonds::mixed ? Block{} : bulk[kind];
        for (int d = 0; kind == Bonds::mixed && d < bonds_per_node; ++d) {
          const auto& of_type = blocks[d];
          b = b + (of_type[bonds.type(i, d)] + of_type[bonds.type(i - bonds.step(d), d)]);
        }
        sum.set(i, b);
      }
    }
  return sum;
}

InverseDiagonal inverse_diagonal(const Bonds& bonds, const BlockDiagonal<double>& diagonal,
                                 const std::vector<std::uint8_t>& prescribed) {
  const Grid& grid = bonds.grid;
  InverseDiagonal inverse{BlockDiagonal<float>(grid.padded_size())};
  grid.each([&](std::ptrdiff_t i, int y) {
    if (!(diagonal.xx[i] + diagonal.yy[i] > 0)) return;
    bool loose = false;
    inverse.blocks.set(i, inverse_of({diagonal.xx[i], diagonal.xy[i], diagonal.yy[i]}, prescribed[y], loose));
    inverse.loose += loose;
  });
  return inverse;
}

}  // namespace arenite::peridynamics
