#include "solid/peridynamics/bonds.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/error.hpp"
#include "core/random.hpp"
#include "support/homogeneous_sample.hpp"

namespace arenite::peridynamics {
namespace {

/// Void, matrix and three grains at random.
PhaseMap speckled(int width, int height, std::uint64_t seed) {
  PhaseMap map = make_phase_map(width, height, 1);
  map.grain_class.assign(3, GrainClass::none);
  RandomStream random(seed, Purpose::test);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const auto kind = static_cast<int>(random.below(5));
    map.phase[i] = kind == 0 ? Phase::empty : kind == 1 ? Phase::matrix : Phase::particle;
    map.grain[i] = kind > 1 ? kind - 2 : -1;
  }
  return map;
}

unsigned type_by_rule(const PhaseMap& map, int x, int y, Offset e) {
  const int u = x + e.x, v = y + e.y;
  if (u < 0 || u >= map.width || v < 0 || v >= map.height) return no_bond;
  const auto a = map.index(x, y), b = map.index(u, v);
  if (map.phase[a] == Phase::empty || map.phase[b] == Phase::empty) return no_bond;
  if (map.phase[a] == Phase::matrix && map.phase[b] == Phase::matrix) return matrix_bond;
  return map.grain[a] == map.grain[b] ? particle_bond : interface_bond;
}

TEST(Bonds, TypeFollowsWhatTheTwoNodesAre) {
  const PhaseMap map = speckled(21, 11, 3);
  const Bonds bonds = make_bonds(map, {});
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      for (int d = 0; d < bonds_per_node; ++d)
        ASSERT_EQ(bonds.type(bonds.grid.index(x, y), d), type_by_rule(map, x, y, half_bonds[static_cast<unsigned>(d)])) << x << " " << y << " " << d;
}

TEST(Bonds, GroupsAreUniformOnlyDeepInsideOnePhase) {
  const PhaseMap map = test::homogeneous_sample(40, 16, Phase::particle);
  const Bonds bonds = make_bonds(map, {});
  EXPECT_EQ(bonds.group[8 * bonds.grid.groups + 2], particle_bond);
  EXPECT_EQ(bonds.group[8 * bonds.grid.groups + 0], Bonds::mixed);
  EXPECT_EQ(bonds.group[2 * bonds.grid.groups + 2], Bonds::mixed);
  EXPECT_EQ(make_bonds(make_phase_map(16, 16, 1), {}).group[20], Bonds::empty);
}

TEST(Bonds, ModulusIsThePapersOrCalibrated) {
  const PhaseMap map = test::homogeneous_sample(8, 8);
  Stiffness s{2e9, 3e9, 8e9, false};
  EXPECT_NEAR(make_bonds(map, s).modulus(particle_bond), 8e9 * nominal_micromodulus, 1);
  EXPECT_NEAR(make_bonds(map, s).modulus(interface_bond), 3e9 * nominal_micromodulus, 1);
  s.calibrated = true;
  EXPECT_NEAR(make_bonds(map, s).modulus(matrix_bond), 2e9 * nominal_micromodulus * 0.9394877, 2e9 * nominal_micromodulus * 1e-7);
}

TEST(Bonds, NarrowMapsAndBadModuliAreRefused) {
  EXPECT_THROW(make_bonds(test::homogeneous_sample(6, 20), {}), InputError);
  EXPECT_THROW(make_bonds(test::homogeneous_sample(8, 8), {1, 0, 4}), InputError);
  EXPECT_THROW(make_bonds(test::homogeneous_sample(8, 8), {-1, 1, 4}), InputError);
}

}  // namespace
}  // namespace arenite::peridynamics
