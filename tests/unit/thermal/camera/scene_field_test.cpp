#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "thermal/camera/camera.hpp"
#include "thermal/camera/expose.hpp"
#include "thermal/camera/scene.hpp"

namespace arenite::camera {
namespace {

constexpr int nodes = 120;
constexpr double dx = 0.5e-3;

double sigma_xx(double x, double y) { return 1e6 + 2e7 * x - 1e7 * y; }
double sigma_yy(double x, double y) { return -3e6 + 1e7 * x + 3e7 * y; }

/// Two disks side by side on a map, under stresses that are linear in place, moved by different ways.
FieldResult two_disks() {
  FieldResult r;
  r.name = "tension";
  r.map = make_phase_map(nodes, nodes, dx);
  r.packing.materials = {{"POM", 1410, 27.35e6, 0.0150e-6}};
  r.packing.domain.thickness = 0.06;
  r.packing.grains.resize(2);
  r.packing.grains.position = {{0.018, 0.030}, {0.042, 0.031}};
  r.packing.grains.radius = {0.011, 0.0115};
  r.map.grain_class = {GrainClass::none, GrainClass::none};
  r.field.width = r.field.height = nodes;
  r.field.dx = dx;
  for (auto* values : {&r.field.ux, &r.field.uy, &r.field.xx, &r.field.yy, &r.field.xy})
    values->assign(r.map.size(), 0);
  for (int y = 0; y < nodes; ++y)
    for (int x = 0; x < nodes; ++x) {
      const Vec2 at{(x + 0.5) * dx, (y + 0.5) * dx};
      const std::size_t k = r.map.index(x, y);
      for (std::size_t g = 0; g < 2; ++g)
        if (norm(at - r.packing.grains.position[g]) < r.packing.grains.radius[g]) {
          r.map.phase[k] = Phase::particle;
          r.map.grain[k] = static_cast<std::int32_t>(g);
          r.field.xx[k] = sigma_xx(at.x, at.y);
          r.field.yy[k] = sigma_yy(at.x, at.y);
          r.field.ux[k] = g == 0 ? 1e-5 : -2e-5;
          r.field.uy[k] = 3e-5;
        }
    }
  return r;
}

TEST(FieldScene, ReadsALinearFieldAsItIs) {
  const FieldResult r = two_disks();
  Parameters p;
  p.optics.pixel = 1.6e-3;
  const Scene scene = scene_of_field(r, p);
  ASSERT_EQ(scene.stress.size(), 2u);
  for (std::size_t g = 0; g < 2; ++g)
    for (const Vec2 off : {Vec2{0, 0}, Vec2{4e-3, -2e-3}, Vec2{-6e-3, 5e-3}, Vec2{1e-3, 7e-3}}) {
      const Vec2 at = scene.grains.position[g] + off;
      EXPECT_NEAR(static_cast<double>(scene.stress[g].at(off)), sigma_xx(at.x, at.y) + sigma_yy(at.x, at.y), 2e3) << g;
    }
  EXPECT_NEAR(scene.travel[0].x, 1e-5, 1e-12);
  EXPECT_NEAR(scene.travel[1].x, -2e-5, 1e-12);
  EXPECT_NEAR(scene.travel[1].y, 3e-5, 1e-12);
}

TEST(FieldScene, CoarsePixelsMissNoNode) {
  FieldResult r = two_disks();
  for (std::size_t k = 0; k < r.map.size(); ++k) r.field.xx[k] = r.field.yy[k] = 0;
  r.field.xx[r.map.index(36, 60)] = 36e6;  // one node at the middle of the first grain
  Parameters p;
  p.optics.pixel = 6e-3;
  p.optics.supersampling = 2;  // cells of six nodes
  double sum = 0;
  const Scene scene = scene_of_field(r, p);
  for (const float v : scene.stress[0].value) sum += static_cast<double>(v) * 9e-6;
  EXPECT_NEAR(sum, 36e6 * dx * dx, 0.05 * 36e6 * dx * dx);
}

TEST(FieldScene, WarmsUnderCompressionByTheFactor) {
  FieldResult r = two_disks();
  for (std::size_t k = 0; k < r.map.size(); ++k) {
    r.field.xx[k] = r.map.grain[k] >= 0 ? -4e6 : 0;
    r.field.yy[k] = r.map.grain[k] >= 0 ? -6e6 : 0;
    r.field.ux[k] = r.field.uy[k] = 0;
  }
  Parameters p;
  p.optics.width = p.optics.height = 40;
  p.optics.blur = 0;
  p.surroundings.radiometry = false;
  p.surroundings.emissivity = {1};
  const Scene scene = scene_of_field(r, p);
  const auto rest = expose(scene, p, 0), loaded = expose(scene, p, 1), half = expose(scene, p, 0.5);
  const double slope = radiometry::photon_exitance_slope(p.band, 296) / radiometry::photon_exitance(p.band, 296);
  float largest = 0;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    largest = std::max(largest, loaded[k] - rest[k]);
    EXPECT_NEAR(static_cast<double>(half[k] - rest[k]), 0.5 * static_cast<double>(loaded[k] - rest[k]), 1e-6);
  }
  EXPECT_NEAR(static_cast<double>(largest), slope * 0.0150e-6 * 10e6, 1e-5);
}

TEST(FieldScene, WhatCannotBeFilmedIsRefused) {
  FieldResult unloaded = two_disks();
  unloaded.field = {};
  EXPECT_THROW(scene_of_field(unloaded, {}), InputError);
  FieldResult picture = two_disks();
  picture.packing.grains.resize(0);
  EXPECT_THROW(scene_of_field(picture, {}), InputError);
}

TEST(SceneOfStates, TheLowerWallTellsLoadAndTravel) {
  Packing low, high;
  low.domain.wall[bottom] = {.position = 1e-3, .force = 200};
  high.domain.wall[bottom] = {.position = 3.5e-3, .force = 5200};
  const WallChange change = change_of_lower_wall(&low, high);
  EXPECT_DOUBLE_EQ(change.force, 5000);
  EXPECT_DOUBLE_EQ(change.travel, 2.5e-3);
  EXPECT_DOUBLE_EQ(change_of_lower_wall(nullptr, high).force, 5200);
  EXPECT_EQ(change_of_lower_wall(nullptr, high).travel, 0);
}

}  // namespace
}  // namespace arenite::camera
