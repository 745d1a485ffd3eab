#include "grains/fields/stage_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/random.hpp"
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
  // Every second state is alike: of differences from the next three, two in three are the swing and one is nothing.
  const double swing = std::abs(share_of(moving, "value") - share_of(before, "value"));
  EXPECT_GT(swing, 4 * share_of(rest, "error"));
  EXPECT_NEAR(share_of(moving, "error"), swing / std::sqrt(3), 1e-9);
  EXPECT_EQ(moving["coordination"]["all"]["error"].get<double>(),
            rest["coordination"]["all"]["error"].get<double>());  // all touch as before
}

/// Told error of the direction of contacts, degrees, that turn with the states; they pass through 90 degrees, where it
/// goes from one end of its range to the other.
template <class Turn> double error_of_direction(Turn&& turn) {
  StageResult result;
  for (std::size_t k = 0; k < 12; ++k) {
    Packing& packing = result.snapshots.emplace_back().packing = test::random_network(3, 400);
    const double turned = 1.6 + turn(k);
    for (std::size_t c = 0; c < packing.contacts.size(); ++c) {
      const double angle = turned + 0.05 * (static_cast<double>(c % 7) - 3);
      packing.contacts.normal[c] = {std::cos(angle), std::sin(angle)};
    }
  }
  texture::Options options;
  options.in_time = texture::TimeScatter{{1, 1, 1, 1}, 0.3};
  const auto texture = texture::measure(result.snapshots.back().packing, options);
  EXPECT_LT(texture::numbers(texture)["fabric"]["theta_c_deg"]["error"].get<double>(), 2);
  const Numbers moving = stage_numbers({result, {}, nullptr, texture, &options});
  return moving["fabric"]["theta_c_deg"]["error"].get<double>();
}

TEST(StageNumbers, DirectionsOfASampleInMotionScatterAsItsStatesDo) {
  constexpr double a = 0.2;  // rad
  const double swinging = error_of_direction(
      [](std::size_t k) { return a * std::sin(2 * std::numbers::pi * static_cast<double>(k) / 6 + 0.5); });
  EXPECT_NEAR(swinging * std::numbers::pi / 180 / (a / std::sqrt(2)), 1, 0.2) << "neighbours differ by half of it only";
  constexpr int samples = 12;
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= samples; ++seed) {
    RandomStream random(seed, Purpose::test);
    const double told = error_of_direction([&](std::size_t) { return a / 2 * random.normal(); });
    squares += told * told / samples;
  }
  EXPECT_NEAR(std::sqrt(squares) * std::numbers::pi / 180 / (a / 2), 1, 0.25);
}

TEST(StageNumbers, AStateWithoutADirectionDoesNotRuleTheErrorOfTheOthers) {
  const double odd = error_of_direction([](std::size_t k) { return k == 5 ? std::numbers::pi / 2 : 0.05 * (k % 3); });
  EXPECT_LT(odd, 26);
  EXPECT_GT(odd, 5);
  const double none = error_of_direction([](std::size_t k) { return 1.9 * static_cast<double>(k * k); });
  EXPECT_NEAR(none, 180 / std::sqrt(12.0), 20);
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
