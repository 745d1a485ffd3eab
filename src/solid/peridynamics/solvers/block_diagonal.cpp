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
    for (unsigned t = 1; t < 4; ++t) {
      bulk[t].xx += 2 * blocks[d][t].xx;
      bulk[t].xy += 2 * blocks[d][t].xy;
      bulk[t].yy += 2 * blocks[d][t].yy;
    }
  for (int y = 0; y < grid.height; ++y)
    for (int g = 0; g < grid.groups; ++g) {
      const auto kind = bonds.group[static_cast<std::ptrdiff_t>(y) * grid.groups + g];
      if (kind == Bonds::empty) continue;
      for (std::ptrdiff_t i = grid.row(y) + g * Grid::lanes, end = i + Grid::lanes; i < end; ++i) {
        Block b{};
        if (kind != Bonds::mixed) {
          b = bulk[kind];
        } else {
          const std::uint32_t word = bonds.words[i];
          for (unsigned d = 0; d < bonds_per_node; ++d) {
            const Block& ahead = blocks[d][word >> (2 * d) & 3u];
            const Block& behind = blocks[d][bonds.words[i - bonds.step(static_cast<int>(d))] >> (2 * d) & 3u];
            b = {b.xx + (ahead.xx + behind.xx), b.xy + (ahead.xy + behind.xy), b.yy + (ahead.yy + behind.yy)};
          }
        }
        sum.xx[i] = b.xx;
        sum.xy[i] = b.xy;
        sum.yy[i] = b.yy;
      }
    }
  return sum;
}

InverseDiagonal inverse_diagonal(const Bonds& bonds, const BlockDiagonal<double>& diagonal, const std::vector<std::uint8_t>& prescribed) {
  const Grid& grid = bonds.grid;
  InverseDiagonal inverse{BlockDiagonal<float>(grid.padded_size())};
  for (int y = 0; y < grid.height; ++y)
    for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) {
      if (!(diagonal.xx[i] + diagonal.yy[i] > 0)) continue;
      bool loose = false;
      const Block b = inverse_of({diagonal.xx[i], diagonal.xy[i], diagonal.yy[i]}, prescribed[static_cast<std::size_t>(y)], loose);
      inverse.loose += loose;
      inverse.blocks.xx[i] = static_cast<float>(b.xx);
      inverse.blocks.xy[i] = static_cast<float>(b.xy);
      inverse.blocks.yy[i] = static_cast<float>(b.yy);
    }
  return inverse;
}

}  // namespace arenite::peridynamics
