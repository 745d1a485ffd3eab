#include "solid/elements/load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "support/element_samples.hpp"
#include "support/pictures.hpp"

namespace arenite::elements::load_in_space_test {
namespace {

using statics::Ending;
using statics::Loading;
using test::alike;
using test::solid;

LoadOptions with(const Material& material, Loading loading = Loading::tension) {
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
    const auto r = load(solid(4, 4, nu == 0 ? 16 : 128, 1e-3), o);
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
  const auto r = load(map, o);
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
  const auto r = load(map, o);
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

/// So small cells that there are three levels.
TEST(VoxelLoad, TheFieldHasTheSameBitsOnAnyNumberOfThreads) {
  const VoxelMap map = test::cemented_spheres(44, false);
  LoadOptions options;
  options.material = test::two_phases();
  options.cell = 4;
  const auto alone = load(map, options);
  ASSERT_EQ(alone.report.ending, statics::Ending::solved);
  ASSERT_GT(alone.report.coarse_nodes, 2000u);
  for (const int threads : {2, 3}) {
    options.threads = threads;
    const auto together = load(map, options);
    EXPECT_EQ(together.report.history, alone.report.history) << threads;
    EXPECT_EQ(together.field.ux, alone.field.ux) << threads;
    EXPECT_EQ(together.field.uz, alone.field.uz) << threads;
    EXPECT_EQ(together.field.zz, alone.field.zz) << threads;
    EXPECT_EQ(together.field.xy, alone.field.xy) << threads;
  }
}

TEST(VoxelLoad, OneLayerIsRefusedAndTwoAreNot) {
  EXPECT_NE(test::complaint([] { load(solid(4, 4, 1), with(alike({1, 0}))); }).find("two layers"), std::string::npos);
  for (const VoxelMap& map : {solid(1, 1, 2), solid(1, 8, 4), solid(8, 1, 4)})
    EXPECT_NEAR(load(map, with(alike({3, 0}))).report.modulus, 3, 1e-5);  // without lateral strain, by ten residuals
}

}  // namespace
}  // namespace arenite::elements::load_in_space_test
