#include "solid/grid/rasterise.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/random.hpp"
#include "solid/grid/crop.hpp"
#include "support/disks.hpp"

namespace arenite::grid {
namespace {

using test::disks;

PhaseMap map_of(const Packing& packing, const Cement& cement, std::int64_t nodes, GridReport& report, double crop = 0) {
  PhaseMap map = rasterise(packing, cement, {nodes, crop}, {}, report);
  check(map);
  return map;
}

/// Places on a coarse grid, so that nodes lie on circles and on edges of bridges and rounding decides.
Packing random_packing(RandomStream& random, int n) {
  std::vector<test::Disk> all;
  const auto place = [&] { return 0.25 * static_cast<double>(random.below(25)) - 3; };
  for (int k = 0; k < n; ++k) all.push_back({place(), place(), 0.5 + 0.25 * static_cast<double>(random.below(3))});
  return disks(all, 3);
}

Cement random_cement(RandomStream& random, int n) {
  Cement cement;
  for (int k = 0; k + 1 < n; ++k) {
    if (k % 3 == 0) cement.menisci.push_back({k, k + 1, random.uniform(0.2, 3)});
    else cement.bridges.push_back({k, k + 1, 0.25, 0.5});
  }
  if (n % 2) cement.coating = 0.25;
  return cement;
}

RC_GTEST_PROP(Grid, OfAMirroredOrTransposedSampleIsTheMirroredOrTransposedMap, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), Purpose::test);
  const int n = *rc::gen::inRange(1, 8), nodes = *rc::gen::element(24, 31, 48);
  const Packing packing = random_packing(random, n);
  const Cement cement = random_cement(random, n);
  Packing mirrored = packing, turned = packing;
  for (Vec2& p : mirrored.grains.position) p.x = -p.x;
  for (Vec2& p : turned.grains.position) std::swap(p.x, p.y);
  GridReport report;
  const PhaseMap map = map_of(packing, cement, nodes, report), flat = transposed(map_of(turned, cement, nodes, report)),
                 mirror = map_of(mirrored, cement, nodes, report);
  RC_ASSERT(flat.phase == map.phase);
  RC_ASSERT(flat.grain == map.grain);
  for (int y = 0; y < nodes; ++y)
    for (int x = 0; x < nodes; ++x) {
      RC_ASSERT(mirror.phase[mirror.index(nodes - 1 - x, y)] == map.phase[map.index(x, y)]);
      RC_ASSERT(mirror.grain[mirror.index(nodes - 1 - x, y)] == map.grain[map.index(x, y)]);
    }
}

TEST(Grid, AreaErrorFallsWithResolution) {
  const Packing three = disks({{-1.03, -0.2, 1}, {1.01, -0.3, 1}, {0.02, 1.35, 0.8}}, 3);
  Cement cement;
  cement.bridges = {{0, 1, 0.6, 0.6}, {1, 2, 0.6, 0.48}};
  cement.menisci = {{0, 2, 0.3}};
  double error[2] = {0, 0};
  // Root mean square over many resolutions: a single one may hit the area by chance.
  for (int k = 0; k < 2; ++k) {
    for (int nodes = 60; nodes < 90; ++nodes) {
      GridReport report;
      map_of(three, cement, k == 0 ? nodes : 8 * nodes, report);
      error[k] += report.particle_area_error * report.particle_area_error / 30;
      EXPECT_EQ(report.necks, 3u);
    }
    error[k] = std::sqrt(error[k]);
  }
  // A smooth outline is counted to better than first order (3/2 for random places of the nodes).
  EXPECT_GT(std::log2(error[0] / error[1]) / 3, 1.2);
  GridReport fine;
  map_of(three, cement, 1200, fine);
  EXPECT_LT(std::abs(fine.matrix_area_error), 0.01);
  EXPECT_EQ(fine.lost_necks, 0u);
}

TEST(Grid, NodesBetweenOverlappingGrainsGoToTheOneTheyAreDeeperIn) {
  GridReport report;
  const PhaseMap map = map_of(disks({{-0.9, 0, 1}, {0.9, 0, 1.2}}, 3), {}, 300, report);
  // Equal power: (x + 0.9)^2 - 1 = (x - 0.9)^2 - 1.44.
  const double line = -0.44 / 3.6;
  for (int x = 0; x < 300; ++x) {
    const double u = (x + 0.5) * 0.02 - 3;
    if (u < -0.25 || u > 0.05 || std::abs(u - line) < 1e-9) continue;
    EXPECT_EQ(map.grain[map.index(x, 149)], u < line ? 0 : 1) << u;
  }
}

TEST(Grid, LabelsNameTheGrainsThatHaveNodesAndKeepTheirClass) {
  GridReport report;
  const Packing packing = disks({{-2.5, 0, 0.4}, {0, 0, 0.5}, {0.4, 2.4, 0.3}, {0.8, 0, 0.25}}, 3);
  const PhaseMap map = rasterise(packing, {}, {40, 2},
                                 {GrainClass::large, GrainClass::large, GrainClass::small, GrainClass::small}, report);
  EXPECT_EQ(report.grain_of_label, (std::vector<std::int32_t>{1, 3}));
  EXPECT_EQ(map.grain_class, (std::vector<GrainClass>{GrainClass::large, GrainClass::small}));
  EXPECT_EQ(report.window.x_min, -1);
  EXPECT_EQ(report.dx, 0.05);
  EXPECT_EQ(report.smallest_grain, 20);  // the other one is cut by the crop
}

TEST(Grid, PeriodicImagesCarryTheirGrainsLabel) {
  GridReport report;
  const PhaseMap map = map_of(disks({{-3, -3, 1}}, 3, true), {}, 60, report);
  for (const auto node : {map.index(0, 0), map.index(59, 0), map.index(0, 59), map.index(59, 59)})
    EXPECT_EQ(map.grain[node], 0);
  EXPECT_NEAR(report.particle_area_error, 0, 0.01);
}

TEST(Grid, ThinAndLostBridgesAreReported) {
  const Packing two = disks({{-1.25, 0.01, 1}, {1.25, 0.01, 1}}, 3);
  const auto report_of = [&](double half) {
    Cement cement;
    cement.bridges = {{0, 1, half, half}};
    GridReport report;
    map_of(two, cement, 60, report);
    return report;
  };
  EXPECT_EQ(report_of(0.25).thinnest_neck, 5);  // rows at -0.15, -0.05, 0.05, 0.15, 0.25
  EXPECT_EQ(report_of(0.25).lost_necks, 0u);
  const GridReport lost = report_of(0.03);  // between two rows of nodes
  EXPECT_EQ(lost.thinnest_neck, 0);
  EXPECT_EQ(lost.lost_necks, 1u);
  EXPECT_NEAR(lost.lost_area, 0.06 * 0.5, 1e-4);
  EXPECT_NEAR(lost.exact_matrix_area, lost.lost_area, 1e-12);
  EXPECT_EQ(lost.matrix_area_error, -1);
}

TEST(Grid, BadInputIsNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Packing one = disks({{0, 0, 1}}, 3);
  GridReport report;
  EXPECT_THROW(map_of(one, {}, 10, report, 6.1), InputError);
  EXPECT_THROW(map_of(one, {}, 10, report, -1), InputError);
  EXPECT_THROW(map_of(one, {}, 10, report, nan), InputError);
  EXPECT_THROW(map_of(one, {}, 0, report), InputError);
  EXPECT_THROW(map_of({}, {}, 10, report), InputError);
  EXPECT_THROW(map_of(disks({{nan, 0, 1}}, 3), {}, 10, report), InputError);
  EXPECT_THROW(map_of(disks({{0, 0, 0}}, 3), {}, 10, report), InputError);
  EXPECT_THROW(rasterise(one, {}, {10, 0}, {GrainClass::large, GrainClass::large}, report), InputError);
  Cement cement;
  cement.bridges = {{0, 1, 0.1, 0.1}};
  EXPECT_THROW(map_of(one, cement, 10, report), InputError);
}

}  // namespace
}  // namespace arenite::grid
