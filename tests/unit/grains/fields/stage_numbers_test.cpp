#include "grains/fields/stage_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/grains/texture/packings.hpp"

namespace arenite::fields {
namespace {

TEST(StageNumbers, AreThoseOfEveryStatistic) {
  StageResult result;
  Packing& packing = result.snapshots.emplace_back().packing;
  packing.materials = {{"glass", 2500, 1e6, 0}};
  packing.domain.wall[right].position = packing.domain.wall[top].position = 0.02;
  packing.grains.resize(2);
  packing.grains.radius = {0.005, 0.005};
  packing.grains.position = {{0.005, 0.005}, {0.015, 0.005}};
  packing.cohesive.push_back({0, 1, -1e-6, 0.4, 0});
  dem::Stage stage;
  stage.gravity = true;
  result.asked.gravity = {0, -9.81};
  const Numbers numbers = stage_numbers({result, stage, nullptr, texture::measure(packing)});
  EXPECT_EQ(numbers["grains"].get<int>(), 2);
  EXPECT_EQ(numbers["surface"]["grains"].get<int>(), 2);
  EXPECT_EQ(numbers["cohesion"]["pairs"].get<int>(), 1);
}

/// A stage of so many states that swings as a whole: in every second one a third of the contacts bear much more.
StageResult swinging(std::size_t states) {
  StageResult result;
  for (std::size_t k = 0; k < states; ++k) {
    Packing& packing = result.snapshots.emplace_back().packing = test::random_network(3, 400);
    for (std::size_t c = 0; c < packing.contacts.size(); ++c)
      if (k % 2 == 1 && c % 3 == 0) packing.contacts.fn[c] *= 20;
  }
  return result;
}

Numbers in_motion(std::size_t states, double pressure) {
  const StageResult result = swinging(states);
  texture::Options options;
  options.in_time = texture::TimeScatter{{1, 1, 1, 1}, pressure};
  const auto texture = texture::measure(result.snapshots.back().packing, options);
  return stage_numbers({result, {}, nullptr, texture, &options});
}

TEST(StageNumbers, OfASampleInMotionHaveTheScatterOfItsStates) {
  const auto rest = texture::numbers(texture::measure(swinging(12).snapshots.back().packing));
  const Numbers moving = in_motion(12, 0.3), before = in_motion(11, 0.3);
  const auto share_of = [](const Numbers& numbers, const char* part) {
    return numbers["force"]["strong_share"][part].get<double>();
  };
  // Neighbouring states differ by their swing, whose deviation is that over the square root of two.
  const double swing = std::abs(share_of(moving, "value") - share_of(before, "value"));
  EXPECT_GT(swing, 4 * share_of(rest, "error"));
  EXPECT_NEAR(share_of(moving, "error"), swing / std::sqrt(2), 1e-9);
  EXPECT_EQ(moving["coordination"]["all"]["error"].get<double>(),
            rest["coordination"]["all"]["error"].get<double>());  // all touch as before
}

TEST(StageNumbers, DirectionsOfASampleInMotionScatterAsItsStatesDo) {
  constexpr double turn = 0.3;  // rad, of every second state
  StageResult result;
  for (std::size_t k = 0; k < 12; ++k) {
    Packing& packing = result.snapshots.emplace_back().packing = test::random_network(3, 400);
    for (std::size_t c = 0; c < packing.contacts.size(); ++c) {
      const double angle = 1.5 + 0.05 * (static_cast<double>(c % 7) - 3) + (k % 2 == 1 ? turn : 0);
      packing.contacts.normal[c] = {std::cos(angle), std::sin(angle)};
    }
  }
  texture::Options options;
  options.in_time = texture::TimeScatter{{1, 1, 1, 1}, 0.3};
  const auto texture = texture::measure(result.snapshots.back().packing, options);
  const Numbers moving = stage_numbers({result, {}, nullptr, texture, &options});
  EXPECT_LT(texture::numbers(texture)["fabric"]["theta_c_deg"]["error"].get<double>(), 2);
  EXPECT_NEAR(moving["fabric"]["theta_c_deg"]["error"].get<double>(), turn * 180 / std::numbers::pi / std::sqrt(2), 0.1)
      << "over 90 degrees, where the direction passes from one end of its range to the other";
}

TEST(StageNumbers, OfASampleInMotionHaveUnknownErrorsWhereStatesAreFewAndThePressureSwings) {
  const Numbers restless = in_motion(2, 0.3);
  EXPECT_FALSE(restless["coordination"]["all"]["error"].is_known());
  EXPECT_NE(restless["notes"].back().get<std::string>().find("store more states"), std::string::npos);
  const Numbers steady = in_motion(2, 0.02);
  EXPECT_TRUE(steady["coordination"]["all"]["error"].is_known());
}

TEST(StageNumbers, EndInMotionWhereSomethingIsDrivenOrTimed) {
  dem::Stage stage;
  stage.side[top] = {dem::SideDrive::Kind::pressure, 1e3};
  EXPECT_FALSE(ends_in_motion(stage));
  stage.shear_rate = 1;
  EXPECT_TRUE(ends_in_motion(stage));
}

}  // namespace
}  // namespace arenite::fields
