#include "solid/peridynamics/cracks.hpp"

#include <cstddef>

#include "solid/peridynamics/failure_bonds.hpp"
#include "solid/peridynamics/lattice.hpp"

namespace arenite::peridynamics {
namespace {

/// Of a bond along one axis, m, from the first node's number and the step to the second.
float middle(int node, int along, double dx) { return static_cast<float>((node + 0.5 + 0.5 * along) * dx); }

}  // namespace

std::vector<float> damage_of(const VoxelMap& map, const std::vector<BrokenBond>& broken, int horizon) {
  const SpaceBonds bonds = make_space_bonds(map, {}, horizon);
  const statics::Grid& grid = bonds.grid;
  Buffer<float> count(grid.padded_size()), lost(grid.padded_size());
  for (int level = 0; level < grid.levels(); ++level)
    each_bond_of_level(bonds, bonds.words, level, [&](const SpaceBond& b) { ++count[b.i], ++count[b.j]; });
  for (const BrokenBond& b : broken) {
    const std::ptrdiff_t i = grid.index(b.x, b.y, b.z);
    ++lost[i], ++lost[i + bonds.step(b.direction)];
  }
  std::vector<float> share;
  grid.each([&](std::ptrdiff_t i, int) { share.push_back(count[i] > 0 ? lost[i] / count[i] : 0.0f); });
  return share;
}

std::vector<Crack> cracks_of(const std::vector<BrokenBond>& broken, double dx) {
  std::vector<Crack> cracks;
  for (const auto& bond : broken) {
    const auto step = half_bonds[bond.direction];
    cracks.push_back({middle(bond.x, step.x, dx), middle(bond.y, step.y, dx), bond.type, bond.strain});
  }
  return cracks;
}

std::vector<SpaceCrack> space_cracks_of(const std::vector<BrokenBond>& broken, int horizon, double dx) {
  const std::vector<SpaceOffset> half = space_half_bonds(horizon);
  std::vector<SpaceCrack> cracks;
  for (const BrokenBond& bond : broken) {
    const SpaceOffset step = half[bond.direction];
    SpaceCrack crack;
    crack.x = middle(bond.x, step.x, dx), crack.y = middle(bond.y, step.y, dx), crack.z = middle(bond.z, step.z, dx);
    crack.type = bond.type, crack.strain = bond.strain;
    crack.along_x = step.x, crack.along_y = step.y, crack.along_z = step.z;
    cracks.push_back(crack);
  }
  return cracks;
}

}  // namespace arenite::peridynamics
