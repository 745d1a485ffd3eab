#include "solid/peridynamics/failure_bonds.hpp"

#include "solid/peridynamics/bonded_aggregates.hpp"
#include "solid/peridynamics/support.hpp"

namespace arenite::peridynamics {

Bonds bonds_of(const PhaseMap& map, const DamageOptionsIn<2>& options) {
  return make_bonds(map, options.stiffness, options.law, options.stop_at_voids);
}

SpaceBonds bonds_of(const VoxelMap& map, const DamageOptionsIn<3>& options) {
  return make_space_bonds(map, options.stiffness, options.horizon_in_space);
}

void make_cuts(SpaceBonds& bonds, const std::vector<Cut>& cuts) {
  if (cuts.empty()) return;
  for (int level = 0; level < bonds.grid.levels(); ++level)
    each_bond_of_level(bonds, bonds.words, level, [&](const SpaceBond& b) {
      const Vec2 from{static_cast<double>(b.x), static_cast<double>(b.z)};
      const Vec2 to = from + Vec2{static_cast<double>(b.along.x), static_cast<double>(b.along.z)};
      if (std::ranges::any_of(cuts, [&](const Cut& cut) { return crosses(cut, from, to); }))
        clear(bonds.words, b.i, b.d);
    });
  mark_groups(bonds);
}

Carrying carrying(const PhaseMap& map, Bonds& bonds, const std::vector<std::uint8_t>& prescribed,
                  Buffer<statics::Tie>& tie) {
  Carrying found{{}, cut_into_aggregates(map, bonds, prescribed)};
  found.support = prune(bonds, found.aggregates, prescribed, tie);
  return found;
}

Carrying carrying(const VoxelMap& map, SpaceBonds& bonds, const std::vector<std::uint8_t>& prescribed,
                  Buffer<statics::Tie>& tie) {
  const statics::Support support = prune_in_space(bonds, map, prescribed, tie);
  return {support, cut_space_bonds(map, bonds, prescribed, space_cell)};
}

}  // namespace arenite::peridynamics
