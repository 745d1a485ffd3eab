#pragma once
#include <array>
#include <cstddef>
#include <numeric>

namespace arenite::peridynamics {

/// Step from a voxel to a neighbour.
struct SpaceOffset {
  int x = 0, y = 0, z = 0;
  constexpr int square() const { return x * x + y * y + z * z; }
  /// How often the shortest step of its direction goes into it.
  constexpr int multiple() const { return std::gcd(std::gcd(x, y), z); }
  constexpr SpaceOffset direction() const { return {x / multiple(), y / multiple(), z / multiple()}; }
};

/// visit(e) for one of each pair +-e of the neighbours within a horizon: the one that lies above, behind or to the
/// right.
template <class Visit> constexpr void each_half_bond_in_space(int reach, const Visit& visit) {
  for (int z = 0; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x) {
        const bool first = z > 0 || y > 0 || (y == 0 && x > 0);
        if (const SpaceOffset e{x, y, z}; first && e.square() <= reach * reach) visit(e);
      }
}
template <int reach> consteval std::size_t count_half_bonds_in_space() {
  std::size_t n = 0;
  each_half_bond_in_space(reach, [&](SpaceOffset) { ++n; });
  return n;
}
template <int reach> consteval auto list_half_bonds_in_space() {
  std::array<SpaceOffset, count_half_bonds_in_space<reach>()> list{};
  std::size_t n = 0;
  each_half_bond_in_space(reach, [&](SpaceOffset e) { list[n++] = e; });
  return list;
}
/// A bond belongs to the node that it starts from: 16 within two spacings, 61 within three.
template <int reach> inline constexpr auto half_bonds_in_space = list_half_bonds_in_space<reach>();

/// Poisson's ratio of a lattice of central forces in space that is isotropic.
inline constexpr double space_lattice_poisson = 0.25;

}  // namespace arenite::peridynamics
