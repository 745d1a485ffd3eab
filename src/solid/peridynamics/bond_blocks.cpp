#include "solid/peridynamics/bond_blocks.hpp"

#include <cmath>

namespace arenite::peridynamics {

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

}  // namespace arenite::peridynamics
