#include "solid/voxels/load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "solid/voxels/label_grains.hpp"
#include "support/voxel_samples.hpp"

namespace arenite::voxels {
namespace {

using statics::Ending;
using statics::Loading;
using test::alike;
using test::solid;

LoadOptions with(Material material, Loading loading = Loading::tension) {
  LoadOptions o;
  o.material = material;
  o.loading = loading;
  return o;
}

TEST(VoxelLoad, ARodWithFreeSidesOnASlidingFaceHasYoungsModulus) {
  // The upper face is held, so that only nu = 0 is uniform there; a slender rod forgets it.
  for (const double nu : {0.0, 0.1, 0.3, 0.45}) {
    LoadOptions o = with(alike({3e9, nu}));
    o.lower = statics::LowerEdge::sliding;
    const LoadResult r = load(solid(4, 4, nu == 0 ? 16 : 128, 1e-3), o);
    ASSERT_EQ(r.report.ending, Ending::solved) << nu;
    EXPECT_NEAR(r.report.modulus / 3e9, 1, nu == 0 ? 1e-6 : 0.01 * nu) << nu;  // the held end: some nu^2 widths of 128
    EXPECT_NEAR(r.report.identity_defect, 0, 1e-5);  // the residual of 1e-6 hides more in long waves
  }
}

TEST(VoxelLoad, LaminatesAcrossTheLoadAreInSeries) {
  VoxelMap map = solid(6, 6, 24);
  map.grain_class = {GrainClass::none};
  for (int z = 0; z < 24; ++z)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 6; ++x)
        if (z % 6 < 3) {
          map.phase[map.index(x, y, z)] = Phase::particle;
          map.grain[map.index(x, y, z)] = 0;
        }
  LoadOptions o = with({{1, 0}, {1, 0}, {10, 0}});  // without lateral strain a face held is a face free
  const LoadResult r = load(map, o);
  ASSERT_EQ(r.report.ending, Ending::solved);
  // Three layers of matrix in six, of which interface is like matrix and takes the layers that touch the other phase:
  // of grain, none; of matrix, two of three.
  EXPECT_NEAR(r.report.modulus, 1 / (0.5 / 1 + 0.5 / 10), 1e-6);
}

TEST(VoxelLoad, WhatHangsByAnEdgeIsLeftOut) {
  VoxelMap map = make_voxel_map(4, 4, 4, 1);
  const auto fill = [&](int x, int y, int z) { map.phase[map.index(x, y, z)] = Phase::matrix; };
  for (int z = 0; z < 4; ++z) fill(0, 0, z);
  fill(1, 1, 2);  // shares an edge with the column
  fill(2, 2, 0);  // hangs on the lower clamp
  fill(3, 3, 3);  // on the upper one
  LoadOptions o = with(alike({2, 0.0}));
  const LoadResult r = load(map, o);
  ASSERT_EQ(r.report.ending, Ending::solved);
  EXPECT_EQ(r.report.support.carrying, 4u);
  EXPECT_EQ(r.report.support.floating, 1u);
  EXPECT_EQ(r.report.support.held_below, 1u);
  EXPECT_EQ(r.report.support.held_above, 1u);
  EXPECT_NEAR(r.report.modulus, 2.0 / 16, 1e-6);
  EXPECT_EQ(r.field.zz[map.index(1, 1, 2)], 0);
}

TEST(VoxelLoad, SeveredAndEmptySamplesSaySo) {
  VoxelMap map = solid(3, 3, 5);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) map.phase[map.index(x, y, 2)] = Phase::empty;
  EXPECT_EQ(load(map, with(alike({1, 0.3}))).report.ending, Ending::severed);
  EXPECT_EQ(load(make_voxel_map(3, 3, 3, 1), with(alike({1, 0.3}))).report.ending, Ending::empty);
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
    VoxelMap map = test::solid(n, n, n);
    const VoxelMap drawn = test::random_voxels(n, n, n);
    for (int z = 0; z < n; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
          const auto k = map.index(x, y, z);
          const auto phase = drawn.phase[drawn.index((x + first) % n, (y + 2 * first) % n, (z + 3 * first) % n)];
          map.phase[k] = phase == Phase::empty ? Phase::matrix : phase;
        }
    label_grains(map);
    SolveOptions o;
    o.tolerance = 1e-7;
    o.cell = 4;
    o.material = {{1, 0.3}, {1, 0.3}, {1, 0.3}};
    o.material.particle = o.material.interface = {20, 0.3};  // alike, however the border of the period cuts grains
    const EffectiveStiffness r = effective_stiffness(map, o);
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
  const EffectiveStiffness r = effective_stiffness(map, o);
  EXPECT_EQ(r.support.carrying, 8u);
  EXPECT_EQ(r.support.floating, 1u);
  EXPECT_EQ(r.support.islands, 1);
  EXPECT_NEAR(r.stiffness[2][2], 1.0 / 64, 1e-7);
  EXPECT_NEAR(r.stiffness[0][0], 0, 1e-7);
}

}  // namespace
}  // namespace arenite::voxels
