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
        ASSERT_EQ(bonds.type(bonds.grid.index(x, y), d), type_by_rule(map, x, y, half_bonds[static_cast<unsigned>(d)]))
            << x << " " << y << " " << d;
}

/// Whether the segment from the middle of one node's square to that of another meets solid all the way, by many points
/// on it: of a point on a corner one of the squares that meet there along the other diagonal suffices.
bool solid_on_the_way(const PhaseMap& map, int x, int y, Offset e) {
  const auto solid = [&](int u, int v) { return map.phase[map.index(u, v)] != Phase::empty; };
  constexpr int points = 840;  // divides by 2 and 3, so that corners are met exactly
  for (int k = 0; k <= points; ++k) {
    // Twice the place, counted from the lower left corner of the first square, in units of 1 / points.
    const int px = points + 2 * k * e.x, py = points + 2 * k * e.y, side = 2 * points;
    const auto floor_of = [&](int p) { return p >= 0 ? p / side : -((-p + side - 1) / side); };
    const int u = floor_of(px), v = floor_of(py);
    const bool on_x = px % side == 0, on_y = py % side == 0;
    if (on_x && on_y) {
      const bool rising = e.x * e.y > 0;
      if (!(rising ? solid(x + u - 1, y + v) || solid(x + u, y + v - 1)
                   : solid(x + u - 1, y + v - 1) || solid(x + u, y + v)))
        return false;
    } else if (!on_x && !on_y && !solid(x + u, y + v)) {
      return false;
    }
  }
  return true;
}

TEST(Bonds, StoppedAtVoidsTheyAreThoseWhoseWayIsSolid) {
  const PhaseMap map = speckled(24, 13, 5);
  const Bonds all = make_bonds(map, {}), stopped = make_bonds(map, {}, {}, true);
  std::size_t across = 0, whole = 0;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      for (int d = 0; d < bonds_per_node; ++d) {
        const auto i = all.grid.index(x, y);
        if (all.type(i, d) == no_bond) continue;
        const bool solid = solid_on_the_way(map, x, y, half_bonds[static_cast<unsigned>(d)]);
        ASSERT_EQ(stopped.type(i, d), solid ? all.type(i, d) : no_bond) << x << " " << y << " " << d;
        (solid ? whole : across) += 1;
      }
  EXPECT_GT(whole, 100u);
  EXPECT_GT(across, 100u);
  EXPECT_EQ(bonds_across_voids(map), across);
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
  EXPECT_NEAR(make_bonds(map, s).modulus(matrix_bond), 2e9 * nominal_micromodulus * 0.9394877,
              2e9 * nominal_micromodulus * 1e-7);
}

TEST(Bonds, NarrowMapsAndBadModuliAreRefused) {
  EXPECT_THROW(make_bonds(test::homogeneous_sample(6, 20), {}), InputError);
  EXPECT_THROW(make_bonds(test::homogeneous_sample(8, 8), {1, 0, 4}), InputError);
  EXPECT_THROW(make_bonds(test::homogeneous_sample(8, 8), {-1, 1, 4}), InputError);
}

}  // namespace
}  // namespace arenite::peridynamics
