#include "grains/fields/loading_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

namespace arenite::fields {
namespace {

using Kind = dem::SideDrive::Kind;

std::optional<Vec3> direction(const std::function<void(dem::Stage&)>& asked) {
  dem::Stage stage;
  asked(stage);
  return loading_direction(stage);
}

void drive(dem::Stage& stage, int side, Kind kind, double value) {
  stage.side[static_cast<std::size_t>(side)].kind = kind;
  stage.side[static_cast<std::size_t>(side)].value = value;
}

void expect_along(const std::optional<Vec3>& found, Vec3 expected) {
  ASSERT_TRUE(found);
  EXPECT_NEAR(std::abs(dot(*found, expected)), 1, 1e-12);
}

TEST(LoadingDirection, IsTheAxisThatATriaxialTestCloses) {
  expect_along(direction([](dem::Stage& stage) {
                 drive(stage, top, Kind::velocity, 0.01);
                 drive(stage, right, Kind::pressure, 1e4);
                 drive(stage, front, Kind::pressure, 1e4);
               }),
               {0, 1, 0});
  expect_along(direction([](dem::Stage& stage) { drive(stage, front, Kind::velocity, 0.01); }), {0, 0, 1});
}

TEST(LoadingDirection, OfSidesThatMoveOutIsTheThird) {
  const auto open = [](dem::Stage& stage) {
    drive(stage, right, Kind::velocity, -0.01);
    drive(stage, front, Kind::velocity, -0.01);
  };
  expect_along(direction(open), {0, 1, 0});
  EXPECT_FALSE(direction([](dem::Stage& stage) { drive(stage, right, Kind::velocity, -0.01); }));
}

TEST(LoadingDirection, OfSimpleShearIsHalfWayBetweenItsAxes) {
  const double half = std::sqrt(0.5);
  expect_along(direction([](dem::Stage& stage) { stage.shear_rate = 2; }), {-half, half, 0});
  expect_along(direction([](dem::Stage& stage) { stage.shear_rate = -2; }), {half, half, 0});
  expect_along(direction([](dem::Stage& stage) { stage.slide[front] = 0.1; }), {-half, 0, half});
  expect_along(direction([](dem::Stage& stage) { stage.slide[left] = 0.1; }), {half, half, 0});
}

TEST(LoadingDirection, OfPressuresIsTheHighestIfOneIs) {
  const auto press = [](double x, double y, double z) {
    return [=](dem::Stage& stage) {
      drive(stage, right, Kind::pressure, x);
      drive(stage, top, Kind::pressure, y);
      drive(stage, front, Kind::pressure, z);
    };
  };
  expect_along(direction(press(1e3, 2e3, 3e3)), {0, 0, 1});
  EXPECT_FALSE(direction(press(1e3, 3e3, 3e3)));
  EXPECT_FALSE(direction(press(3e3, 3e3, 1e3)));
  expect_along(direction([](dem::Stage& stage) { drive(stage, top, Kind::force, 5); }), {0, 1, 0});
  EXPECT_FALSE(direction([](dem::Stage&) {}));
}

}  // namespace
}  // namespace arenite::fields
