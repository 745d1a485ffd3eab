#include "geometry/round_bridge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/liquid_bridge.hpp"

namespace {
using namespace arenite;
using namespace arenite::geometry;
constexpr double pi = std::numbers::pi;

TEST(RoundBridge, IsFishersBetweenEqualSpheres) {
  for (const double gap : {0.0, 0.05, 0.2})
    for (const double angle : {0.0, 0.3, 0.9}) {
      const double filling = 0.5;
      const auto shape = round_bridge({1, 1, 2 + gap}, angle, std::sin(filling));
      ASSERT_TRUE(shape) << gap << " " << angle;
      EXPECT_NEAR(shape->radius, (gap / 2 + 1 - std::cos(filling)) / std::cos(filling + angle), 1e-12);
      EXPECT_NEAR(shape->centre.x, 1 + gap / 2, 1e-12);
      EXPECT_NEAR(shape->touch_j.x, 2 + gap - shape->touch_i.x, 1e-12);
      EXPECT_NEAR(shape->touch_j.y, shape->touch_i.y, 1e-12);
    }
}

TEST(RoundBridge, MeetsBothSpheresAtItsAngle) {
  // Between the normals of arc and sphere at each end; of spheres that differ, that touch, and that overlap.
  for (const double distance : {2.3, 2.2, 2.05})
    for (const double angle : {0.0, 0.4, 1.0}) {
      const auto shape = round_bridge({0.7, 1.5, distance}, angle, 0.65);
      ASSERT_TRUE(shape) << distance << " " << angle;
      const Vec2 j{distance, 0}, to_arc_i = shape->centre - shape->touch_i, to_arc_j = shape->centre - shape->touch_j;
      EXPECT_NEAR(norm(shape->touch_i), 0.7, 1e-12);
      EXPECT_NEAR(norm(shape->touch_j - j), 1.5, 1e-12);
      EXPECT_NEAR(norm(to_arc_j), shape->radius, 1e-9);
      EXPECT_NEAR(dot(to_arc_i, shape->touch_i) / shape->radius / 0.7, std::cos(angle), 1e-9);
      EXPECT_NEAR(dot(to_arc_j, shape->touch_j - j) / shape->radius / 1.5, std::cos(angle), 1e-9);
      EXPECT_NEAR(shape->touch_i.y, 0.65 * 0.7, 1e-12);
    }
}

TEST(RoundBridge, IsTheSectionOfTheBridgeOfThePlane) {
  const LiquidBridge liquid{0.8, 1.3, 0.6};
  const auto shape = round_bridge({0.8, 1.3, 2.2}, 0.6, 0.5);
  ASSERT_TRUE(shape);
  const BridgeState state = bridge_state(liquid, 0.1, shape->radius);
  EXPECT_NEAR(state.neck, shape->centre.y - shape->radius, 1e-12);
  double area = 0;  // of both halves, counted
  constexpr int n = 2000;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) {
      const Vec2 p{2.2 * (a + 0.5) / n, 0.7 * (b + 0.5) / n};
      const bool in_sphere = norm(p) < 0.8 || norm(p - Vec2{2.2, 0}) < 1.3;
      area += !in_sphere && shape->contains(p) ? 2 * 2.2 * 0.7 / n / n : 0;
    }
  EXPECT_NEAR(area / state.area, 1, 2e-3);
}

TEST(RoundBridge, IsAtMostStraightAndRupturesAcrossAGap) {
  const auto straight = round_bridge({1, 1, 2.5}, 0.3, 1);
  ASSERT_TRUE(straight);
  EXPECT_EQ(straight->radius, 0);
  EXPECT_NEAR(straight->touch_i.y, std::sin(pi / 2 - 0.3), 1e-12);
  EXPECT_NEAR(straight->touch_j.y, straight->touch_i.y, 1e-12);
  EXPECT_FALSE(round_bridge({1, 1, 2.5}, 0.3, 0.1));  // 0.25/cos(0.4) > 0.1 wide
  EXPECT_TRUE(round_bridge({1, 1, 2}, 0, 0.1));
  EXPECT_FALSE(round_bridge({1, 1, 1.6}, 0, 0.5));  // the overlap is 0.6 wide
  EXPECT_FALSE(round_bridge({1, 3, 1.5}, 0, 0.5));
  EXPECT_FALSE(round_bridge({1, 1, 2}, 0, 0));
}

}  // namespace
