#include "geometry/ball_window.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "geometry/union_area.hpp"

namespace arenite::geometry {
namespace {

const double whole = 4.0 / 3.0 * std::numbers::pi * 8;  // of a ball of radius 2

TEST(BallWindow, ABallWithinIsWholeAndOneBesideIsNot) {
  EXPECT_DOUBLE_EQ(ball_window_volume({5, 5, 5}, 2, {{0, 0, 0}, {10, 10, 10}}), whole);
  EXPECT_EQ(ball_window_volume({13, 5, 5}, 2, {{0, 0, 0}, {10, 10, 10}}), 0);
}

TEST(BallWindow, ASideCutsACapOff) {
  for (const double height : {0.5, 1.0, 2.0, 3.5}) {
    const double cap = std::numbers::pi * height * height * (6 - height) / 3;  // pi h^2 (3 r - h)/3
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 centre{5, 5, 5};
      centre[axis] = 8 + height;
      EXPECT_NEAR(ball_window_volume(centre, 2, {{0, 0, 0}, {10, 10, 10}}), whole - cap, 1e-12);
    }
  }
}

TEST(BallWindow, EdgesAndCornersLeaveQuartersAndEighths) {
  EXPECT_NEAR(ball_window_volume({0, 0, 5}, 2, {{0, 0, 0}, {10, 10, 10}}), whole / 4, 1e-14 * whole);
  EXPECT_NEAR(ball_window_volume({0, 10, 0}, 2, {{0, 0, 0}, {10, 10, 10}}), whole / 8, 1e-14 * whole);
}

TEST(BallWindow, BlocksOfABoxHaveTheWholeBetweenThem) {
  double sum = 0;
  for (int b = 0; b < 27; ++b) {
    const Vec3 corner{3.0 * (b % 3), 3.0 * (b / 3 % 3), 3.0 * (b / 9)};
    sum += ball_window_volume({4.1, 5.3, 3.2}, 2, {corner, {3, 3, 3}});
  }
  EXPECT_NEAR(sum, whole, 1e-13 * whole);
}

TEST(BallWindow, SlicesOfAnyBoxAddUpToIt) {
  RandomStream random(1, Purpose::test);
  for (int trial = 0; trial < 300; ++trial) {
    Vec3 low, size;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = random.uniform(-2.5, 1.5);
      size[axis] = random.uniform(0.2, 4.0);
    }
    constexpr int slices = 4000;
    const double thickness = size.z / slices;
    double sum = 0;
    for (int k = 0; k < slices; ++k) {
      const double z = low.z + (k + 0.5) * thickness;
      if (std::abs(z) < 2)
        sum += thickness * disk_window_area({}, std::sqrt(4 - z * z), {low.x, low.x + size.x, low.y, low.y + size.y});
    }
    EXPECT_NEAR(ball_window_volume({}, 2, {low, size}), sum, 2e-5 * whole);
  }
}

TEST(BallWindow, OneThatJustTouchesAnEdgeOrACornerHasNoRoundedNonsense) {
  for (const double off : {1e-17, 1e-15, 1e-9})
    for (const double angle : {0.1, 0.7, 1.5}) {
      const Vec3 at{-2 * std::cos(angle) + off, -2 * std::sin(angle) + off, 0};
      const double beside = ball_window_volume(at, 2, {{0, 0, -5}, {10, 10, 10}});
      EXPECT_GE(beside, -1e-14);
      EXPECT_LT(beside, 1e-7);
    }
}

}  // namespace
}  // namespace arenite::geometry
