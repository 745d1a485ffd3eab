#pragma once
#include "solid/peridynamics/bonds.hpp"

namespace arenite::peridynamics {

/// One whole bond: the node that it starts from, at (x, y), its other end j, its direction (index into half_bonds) and
/// its type.
struct Bond {
  std::ptrdiff_t i, j;
  std::int32_t x, y;
  int d;
  unsigned type;
  Offset step() const { return half_bonds[static_cast<unsigned>(d)]; }
};

/// Every whole bond that starts in row y once, handed to `visit(Bond)`; a visitor may break the bond that it is handed.
template <class Visit>
void each_bond_of_row(const Bonds& bonds, int y, const Visit& visit) {
  for (int x = 0; x < bonds.grid.width; ++x) {
    const std::ptrdiff_t i = bonds.grid.index(x, y);
    const std::uint32_t word = bonds.words[i];
    if (!word) continue;
    for (int d = 0; d < bonds_per_node; ++d)
      if (const unsigned type = word >> (2 * d) & 3u) visit(Bond{i, i + bonds.step(d), x, y, d, type});
  }
}

/// The same for all rows, upwards.
template <class Visit>
void each_bond(const Bonds& bonds, const Visit& visit) {
  for (int y = 0; y < bonds.grid.height; ++y) each_bond_of_row(bonds, y, visit);
}

}  // namespace arenite::peridynamics
