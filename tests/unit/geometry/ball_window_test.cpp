#include "geometry/ball_window.hpp"

#include <gtest/gtest.h>

#include <numbers>

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
  EXPECT_NEAR(ball_window_volume({0, 0, 5}, 2, {{0, 0, 0}, {10, 10, 10}}), whole / 4, 1e-3 * whole);
  EXPECT_NEAR(ball_window_volume({0, 10, 0}, 2, {{0, 0, 0}, {10, 10, 10}}), whole / 8, 1e-3 * whole);
}

TEST(BallWindow, BlocksOfABoxHaveTheWholeBetweenThem) {
  double sum = 0;
  for (int b = 0; b < 27; ++b) {
    const Vec3 corner{3.0 * (b % 3), 3.0 * (b / 3 % 3), 3.0 * (b / 9)};
    sum += ball_window_volume({4.1, 5.3, 3.2}, 2, {corner, {3, 3, 3}});
  }
  EXPECT_NEAR(sum, whole, 1e-3 * whole);
}

}  // namespace
}  // namespace arenite::geometry
