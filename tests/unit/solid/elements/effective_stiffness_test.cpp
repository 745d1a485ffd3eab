#include "solid/elements/effective_stiffness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/random.hpp"
#include "core/vec.hpp"
#include "solid/elements/stiffness_numbers.hpp"
#include "solid/grid/label_grains.hpp"
#include "support/element_samples.hpp"

namespace arenite::elements::effective_stiffness_test {
namespace {

using test::alike;
using test::solid;

void make_grain(PhaseMap& map, int x, int y) {
  map.phase[map.index(x, y)] = Phase::particle;
  map.grain[map.index(x, y)] = 0;
  map.grain_class = {GrainClass::none};
}

TEST(EffectiveStiffness, OfOneMaterialOfThePlaneIsItsOwn) {
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain}) {
    SolveOptions o;
    o.material = alike({5, 0.3});
    o.material.plane = state;
    const auto c = effective_stiffness(solid(19, 23), o).stiffness;
    const double g = 5 / 2.6, c11 = state == PlaneState::stress ? 5 / 0.91 : 5 * 0.7 / (1.3 * 0.4),
                 c12 = state == PlaneState::stress ? 0.3 * c11 : 5 * 0.3 / (1.3 * 0.4);
    const std::array<std::array<double, 3>, 3> wanted{{{c11, c12, 0}, {c12, c11, 0}, {0, 0, g}}};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(c[a][b], wanted[a][b], 5e-6) << a << b;
  }
}

TEST(EffectiveStiffness, OfLaminatesOfThePlaneIsThatOfBackus) {
  // Layers normal to y of equal thickness: what goes along is a mean of stiffness, what goes across of compliance.
  PhaseMap map = solid(20, 20);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 20; ++x) make_grain(map, x, y);
  SolveOptions o;
  o.tolerance = 1e-8;
  o.material = {{1, 0.4}, {1, 0.4}, {20, 0.2}};
  const auto c = effective_stiffness(map, o).stiffness;
  const auto mean = [](const auto& of) { return (of(1.0, 0.4) + of(20.0, 0.2)) / 2; };
  const auto axial = [](double e, double nu) { return e / (1 - nu * nu); };
  const double c22 = 1 / mean([&](double e, double nu) { return 1 / axial(e, nu); });
  const double ratio = mean([](double, double nu) { return nu; });
  EXPECT_NEAR(c[1][1], c22, 1e-5);
  EXPECT_NEAR(c[0][1], ratio * c22, 1e-5);
  EXPECT_NEAR(c[1][0], ratio * c22, 1e-5);
  EXPECT_NEAR(c[0][0], mean([](double e, double) { return e; }) + ratio * ratio * c22, 1e-5);
  EXPECT_NEAR(c[2][2], 1 / mean([](double e, double nu) { return 2 * (1 + nu) / e; }), 1e-5);
}

TEST(EffectiveStiffness, OfFewHolesIsTheDiluteOne) {
  // A hole of radius 12 in a period of 160: 1.8 % of area. Dilute holes: 1/K and 1/G rise by p and 2 p times
  // 1/K + 1/G, so that E falls by 3 p whatever Poisson's ratio is. Its rim of steps costs about a per cent of that, and
  // its images as much as there is of it.
  constexpr int n = 160;
  PhaseMap map = solid(n, n);
  double holes = 0;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      if (std::hypot(x - n / 2 + 0.5, y - n / 2 + 0.5) <= 12) {
        map.phase[map.index(x, y)] = Phase::empty;
        holes += 1.0 / (n * n);
      }
  for (const double nu : {0.0, 0.3, 0.45}) {
    SolveOptions o;
    o.material = alike({1, nu});
    const auto r = effective_stiffness(map, o);
    const double bulk = (r.stiffness[0][0] + r.stiffness[0][1]) / 2;
    // A square array answers the two kinds of shear a little differently; their mean is that of a random one.
    const double shear = ((r.stiffness[0][0] - r.stiffness[0][1]) / 2 + r.stiffness[2][2]) / 2;
    const double young = 4 * bulk * shear / (bulk + shear);
    EXPECT_NEAR((1 / young - 1) / (3 * holes), 1, 0.06) << nu;
    EXPECT_LT(bulk, r.bounds.shtrikman_upper.bulk);
    EXPECT_LT(shear, r.bounds.shtrikman_upper.shear);
    const Numbers told = stiffness_numbers(r);
    EXPECT_NEAR(told["isotropic_mean_Pa"]["young"].get<double>(), young, 1e-12) << nu;
    EXPECT_LT(told["anisotropy"].get<double>(), 1) << nu;  // a square array is stiffer along its axes
  }
}

// A plate whose period is empty above it: what the solver leaves across it is rounding, not a modulus.
TEST(EffectiveStiffness, OfAPlateHasNoModuliButSaysSo) {
  EffectiveStiffness<3> plate;
  for (std::size_t k = 0; k < 6; ++k) plate.stiffness[k][k] = k % 2 == 0 ? 2.5e8 : -1e-8;
  const Numbers told = stiffness_numbers(plate);
  EXPECT_FALSE(told.contains("young_Pa") || told.contains("poisson"));
  EXPECT_NE(told["notes"][0].get<std::string>().find("no moduli"), std::string::npos);
  for (std::size_t k = 0; k < 6; ++k) plate.stiffness[k][k] = 2.5e8;
  EXPECT_NEAR(stiffness_numbers(plate)["young_Pa"][1].get<double>(), 2.5e8, 1);
}

TEST(EffectiveStiffness, OfThePlaneKnowsNoFirstPixel) {
  constexpr int n = 50;  // no multiple of the coarse cells, nor of a vector
  const auto stiffness_from = [&](int first) {
    PhaseMap map = solid(n, n);
    RandomStream random(7, Purpose::test);
    std::array<int, 12> x, y;
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] = static_cast<int>(random.uniform(0, n)), y[k] = static_cast<int>(random.uniform(0, n));
    for (std::size_t k = 0; k < x.size(); ++k)
      for (int b = 0; b < 9; ++b)
        for (int a = 0; a < 9; ++a) make_grain(map, (x[k] + a + first) % n, (y[k] + b + 2 * first) % n);
    SolveOptions o;
    o.tolerance = 1e-7;
    o.material = {{1, 0.3}, {1, 0.3}, {20, 0.2}};
    const auto r = effective_stiffness(map, o);
    for (const auto& solve : r.solves) EXPECT_TRUE(solve.converged) << solve.residual;
    return r.stiffness;
  };
  const auto here = stiffness_from(0), there = stiffness_from(17);
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) {
      EXPECT_NEAR(here[a][b], there[a][b], 1e-5 * here[0][0]) << a << b;
      EXPECT_NEAR(here[a][b], here[b][a], 1e-5 * here[0][0]) << a << b;
    }
}

TEST(EffectiveStiffness, OfOneMaterialIsItsOwn) {
  SolveOptions o;
  o.material = alike({5, 0.3});
  const auto c = effective_stiffness(solid(7, 8, 9, 1e-3), o).stiffness;
  const double mu = 5 / 2.6, lambda = 5 * 0.3 / (1.3 * 0.4);
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = 0; b < 6; ++b) {
      const double wanted = a < 3 && b < 3 ? lambda + (a == b ? 2 * mu : 0) : a == b ? mu : 0;
      EXPECT_NEAR(c[a][b], wanted, 5e-6) << a << b;
    }
}

TEST(EffectiveStiffness, OfLaminatesIsThatOfBackus) {
  // Layers normal to z of equal thickness; Backus (1962). The interface phase is made of the matrix, which it is cut
  // from.
  VoxelMap map = solid(8, 8, 8);
  map.grain_class = {GrainClass::none};
  for (std::size_t k = 0; k < map.size(); ++k)
    if (k / 64 < 4) {
      map.phase[k] = Phase::particle;
      map.grain[k] = 0;
    }
  SolveOptions o;
  o.tolerance = 1e-8;
  o.material = {{1, 0.4}, {1, 0.4}, {20, 0.2}};
  const auto c = effective_stiffness(map, o).stiffness;
  const auto mean = [](const auto& of) { return (of(1.0, 0.4) + of(20.0, 0.2)) / 2; };
  const auto mu = [](double e, double nu) { return e / (2 * (1 + nu)); };
  const auto lambda = [](double e, double nu) { return e * nu / ((1 + nu) * (1 - 2 * nu)); };
  const auto stiff = [&](double e, double nu) { return lambda(e, nu) + 2 * mu(e, nu); };
  const double c33 = 1 / mean([&](double e, double nu) { return 1 / stiff(e, nu); });
  const double ratio = mean([&](double e, double nu) { return lambda(e, nu) / stiff(e, nu); });
  const double c44 = 1 / mean([&](double e, double nu) { return 1 / mu(e, nu); });
  const double c66 = mean(mu);
  const double c12 =
      mean([&](double e, double nu) { return 2 * mu(e, nu) * lambda(e, nu) / stiff(e, nu); }) + ratio * ratio * c33;
  EXPECT_NEAR(c[2][2], c33, 1e-5);
  EXPECT_NEAR(c[0][2], ratio * c33, 1e-5);
  EXPECT_NEAR(c[2][0], ratio * c33, 1e-5);
  EXPECT_NEAR(c[3][3], c44, 1e-5);
  EXPECT_NEAR(c[4][4], c44, 1e-5);
  EXPECT_NEAR(c[5][5], c66, 1e-5);
  EXPECT_NEAR(c[0][1], c12, 1e-5);
  EXPECT_NEAR(c[0][0], c12 + 2 * c66, 1e-5);
}

TEST(EffectiveStiffness, OfManyGrainsKnowsNoFirstVoxel) {
  // Grains of a few voxels leave the coarse space corners that hardly any voxel feels; a period may begin anywhere.
  constexpr int n = 16;
  const auto stiffness_from = [&](int first) {
    VoxelMap map = solid(n, n, n);
    const VoxelMap drawn = test::random_voxels(n, n, n);
    for (int z = 0; z < n; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
          const auto k = map.index(x, y, z);
          const auto phase = drawn.phase[drawn.index((x + first) % n, (y + 2 * first) % n, (z + 3 * first) % n)];
          map.phase[k] = phase == Phase::empty ? Phase::matrix : phase;
        }
    grid::label_grains(map);
    SolveOptions o;
    o.tolerance = 1e-7;
    o.cell = 4;
    o.material = {{1, 0.3}, {1, 0.3}, {1, 0.3}};
    o.material.particle = o.material.interface = {20, 0.3};  // alike, however the border of the period cuts grains
    const auto r = effective_stiffness(map, o);
    for (const auto& solve : r.solves) EXPECT_TRUE(solve.converged) << solve.residual;
    return r.stiffness;
  };
  const auto here = stiffness_from(0), there = stiffness_from(5);
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = 0; b < 6; ++b) {
      EXPECT_NEAR(here[a][b], there[a][b], 1e-5 * here[0][0]) << a << b;
      EXPECT_NEAR(here[a][b], here[b][a], 1e-5 * here[0][0]) << a << b;
    }
}

TEST(EffectiveStiffness, IslandsCarryNothing) {
  VoxelMap map = make_voxel_map(8, 8, 8, 1);
  for (int z = 0; z < 8; ++z) map.phase[map.index(2, 3, z)] = Phase::matrix;  // a column that meets its image
  map.phase[map.index(6, 6, 6)] = Phase::matrix;
  SolveOptions o;
  o.material = alike({1, 0.0});
  const auto r = effective_stiffness(map, o);
  EXPECT_EQ(r.support.carrying, 8u);
  EXPECT_EQ(r.support.floating, 1u);
  EXPECT_EQ(r.support.islands, 1);
  EXPECT_NEAR(r.stiffness[2][2], 1.0 / 64, 1e-7);
  EXPECT_NEAR(r.stiffness[0][0], 0, 1e-7);
}

}  // namespace
}  // namespace arenite::elements::effective_stiffness_test
