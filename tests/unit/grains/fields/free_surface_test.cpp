#include "grains/fields/free_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace arenite::fields {
namespace {

constexpr double radius = 0.0025, slope_degree = std::numbers::pi / 180;

/// Disks in rows, all whose centres lie below a roof that falls from its ridge to the left and to the right, turned
/// about the origin.
Packing heap(double ridge, double height, double left_angle, double right_angle, double turned = 0) {
  Packing p;
  p.materials = {{"glass", 2500, 1e6, 0}};
  Grains& g = p.grains;
  const double row = std::sqrt(3) * radius;
  for (int r = 0; r * row < height; ++r)
    for (int c = -400; c < 400; ++c) {
      const double x = ridge + (2 * c + r % 2) * radius, y = r * row;
      const double roof =
          height - (x < ridge ? (ridge - x) * std::tan(left_angle) : (x - ridge) * std::tan(right_angle));
      if (y > roof || x < 0) continue;
      g.resize(g.size() + 1);
      g.position.back() = {x * std::cos(turned) - y * std::sin(turned), x * std::sin(turned) + y * std::cos(turned)};
      g.radius.back() = radius;
    }
  return p;
}

Vec2 down(double turned = 0) { return {9.81 * std::sin(turned), -9.81 * std::cos(turned)}; }

TEST(FreeSurface, HasTheAnglesOfAHeapThatWasBuiltWithThem) {
  const Packing p = heap(0.4, 0.12, 20 * slope_degree, 31 * slope_degree);
  const FreeSurface s = find_free_surface(p, down());
  EXPECT_EQ(s.grains, p.grains.size());
  EXPECT_NEAR(s.left_flank.angle.value / slope_degree, 20, 0.6);
  EXPECT_NEAR(s.right_flank.angle.value / slope_degree, 31, 0.6);
  for (const Flank* flank : {&s.left_flank, &s.right_flank}) EXPECT_LT(flank->angle.error, slope_degree);
  EXPECT_GT(s.angle.value, s.left_flank.angle.value);
  EXPECT_LT(s.angle.value, s.right_flank.angle.value);
  EXPECT_NEAR(s.top, 0.12, 2 * radius);
  EXPECT_NEAR(s.right, 0.4 + 0.12 / std::tan(31 * slope_degree), 2 * radius);
}

TEST(FreeSurface, IsTheSameHoweverFrameAndGravityAreTurned) {
  const FreeSurface straight = find_free_surface(heap(0, 0.12, 25 * slope_degree, 25 * slope_degree), down());
  EXPECT_EQ(straight.left_flank.columns, 0u);  // the ridge stands at the left end
  EXPECT_NEAR(straight.angle.value / slope_degree, 25, 0.6);
  for (const double turned : {0.3, -1.2, 2.5}) {
    const FreeSurface s = find_free_surface(heap(0, 0.12, 25 * slope_degree, 25 * slope_degree, turned), down(turned));
    EXPECT_NEAR(s.angle.value, straight.angle.value, 1e-6);
    EXPECT_NEAR(s.right - s.left, straight.right - straight.left, 1e-9);
  }
}

TEST(FreeSurface, LeavesOutGrainsThatRolledAhead) {
  Packing p = heap(0, 0.12, 25 * slope_degree, 25 * slope_degree);
  const FreeSurface before = find_free_surface(p, down());
  Grains& g = p.grains;
  g.resize(g.size() + 1);
  g.position.back().x = before.right + 0.05;
  g.radius.back() = radius;
  const FreeSurface after = find_free_surface(p, down());
  EXPECT_EQ(after.right, before.right);
  EXPECT_EQ(after.grains, before.grains);
}

TEST(FreeSurface, HasNoAngleWhereItIsFlatAndRefusesWhatMakesNoSense) {
  const Packing flat = heap(0, 0.05, 0, 1e-9);
  EXPECT_TRUE(std::isnan(find_free_surface(flat, down()).angle.value));
  EXPECT_THROW(find_free_surface(flat, {}), InputError);
  EXPECT_THROW(find_free_surface(Packing{}, down()), InputError);
  EXPECT_THROW(find_free_surface(flat, down(), -0.1), InputError);
}

TEST(FreeSurface, TheFrontThatHasGoneFartherIsTold) {
  const FreeSurface then = find_free_surface(heap(0.4, 0.12, 25 * slope_degree, 25 * slope_degree), down());
  FreeSurface now = then;
  now.left -= 0.02, now.right += 0.01;
  EXPECT_FALSE(farther_front(then, now).to_right);
  EXPECT_NEAR(farther_front(then, now).way, 0.02, 1e-12);
  EXPECT_NEAR(way_of_front(true, then, now), 0.01, 1e-12);
}

/// The same heap of spheres, from the back to the front of a container of six diameters.
PackingIn<3> ridge_of_spheres(double left_angle, double right_angle) {
  constexpr int deep = 6;
  const Packing flat = heap(0.4, 0.12, left_angle, right_angle);
  PackingIn<3> p;
  p.materials = flat.materials;
  p.domain.wall[front].position = 2 * radius * deep;
  for (std::size_t k = 0; k < deep * flat.grains.size(); ++k) {
    const Vec2 at = flat.grains.position[k / deep];
    p.grains.resize(k + 1);
    p.grains.position.back() = {at.x, at.y, (2 * static_cast<double>(k % deep) + 1) * radius};
    p.grains.radius.back() = radius;
  }
  return p;
}

TEST(FreeSurface, OfSpheresIsTheMeanOverTheDepth) {
  const double left_angle = 20 * slope_degree, right_angle = 31 * slope_degree;
  const FreeSurface flat = find_free_surface(heap(0.4, 0.12, left_angle, right_angle), down());
  PackingIn<3> ridge = ridge_of_spheres(left_angle, right_angle);
  const FreeSurface s = find_free_surface(ridge, down());
  EXPECT_TRUE(s.fills_depth);
  EXPECT_EQ(s.grains, ridge.grains.size());
  ASSERT_EQ(s.height.size(), flat.height.size());
  for (std::size_t k = 0; k < s.height.size(); ++k) EXPECT_NEAR(s.height[k], flat.height[k], 1e-8);
  EXPECT_NEAR(s.angle.value, flat.angle.value, 1e-6);
  ridge.domain.wall[front].position *= 2;  // as if it were a heap that may spread along z
  const FreeSurface free = find_free_surface(ridge, down());
  EXPECT_FALSE(free.fills_depth);
  EXPECT_TRUE(std::isnan(free.angle.value));
  EXPECT_EQ(free.right, s.right);
}

}  // namespace
}  // namespace arenite::fields
