#include "workflow/predict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grains/dem/run_stage.hpp"
#include "support/small_study.hpp"

namespace arenite {
namespace {

using std::numbers::pi;

/// Two disks of POM, one of them larger, 60 mm long.
Packing two_disks(double radius, double larger) {
  Packing packing;
  packing.materials = {{"POM", 1410, 27.35e6, 0}};
  packing.domain.thickness = 0.06;
  packing.domain.wall[right].position = packing.domain.wall[top].position = 1;
  packing.grains.resize(2);
  packing.grains.radius = {radius, larger};
  packing.grains.position = {{0.3, 0.5}, {0.6, 0.5}};
  return packing;
}

TEST(Collision, OfTwoEqualDisksLastsHalfAPeriodOfTheirSpring) {
  const double mass = 1410 * pi * 0.005 * 0.005 * 0.06;
  EXPECT_NEAR(workflow::collision_time(mass / 2, 27.35e6), pi / std::sqrt(2 * 27.35e6 / mass), 1e-18);
  const auto shortest = workflow::shortest_collision(two_disks(0.005, 0.008), {});
  EXPECT_NEAR(shortest.time, workflow::collision_time(mass / 2, 27.35e6), 1e-15);
  EXPECT_EQ(shortest.radius, 0.005);
  EXPECT_FALSE(shortest.with_wall);
}

TEST(Steps, AreADurationOverTheStepRoundedUp) {
  EXPECT_EQ(dem::steps_of(0.5, 1e-3), 500);
  EXPECT_EQ(dem::steps_of(0.5004, 1e-3), 501);
}

TEST(InertialNumber, IsThatOfAHandCalculation) {
  EXPECT_NEAR(workflow::inertial_number(0.3, 0.008, 1200, 50e3), 0.0024 * std::sqrt(0.024), 1e-15);
  EXPECT_EQ(workflow::flow_regime(9e-4), "quasi-static");
  EXPECT_EQ(workflow::flow_regime(1e-3), "dense flow");
  EXPECT_EQ(workflow::flow_regime(0.1), "dense flow");
  EXPECT_EQ(workflow::flow_regime(0.11), "inertial");
}

TEST(StiffnessNumber, IsStiffnessOverPressureTimesLengthForALinearLaw) {
  EXPECT_NEAR(workflow::stiffness_number(dem::Linear{}, 1e6, 0.002, 0.01, 1e4), 1e4, 1e-6);
}

TEST(StiffnessNumber, GrowsAsThePressureToMinusTwoThirdsForHertz) {
  const double share = 1e4 * 0.01 / (2 * 1e6);  // P L/(2 k), for 1/R* = 4/d
  EXPECT_NEAR(workflow::stiffness_number(dem::Hertz{}, 1e6, 0.002, 0.01, 1e4) * std::pow(share, 2.0 / 3), 1, 1e-9);
}

TEST(Overlap, OfGrainsThatAreTooSoftIsTheirDiameter) {
  EXPECT_EQ(workflow::overlap_under(dem::Linear{}, 10, 0.01, 1e3), 0.01);
}

TEST(SettlingTime, IsShorterWithDragAndLongerForAStricterRest) {
  const double period = 8e-3;
  const double without = workflow::settling_time(period, 0, 1e-4);
  EXPECT_NEAR(without, 4.5 * period * std::log(1e4), 1e-12);
  EXPECT_LT(workflow::settling_time(period, 100, 1e-4), without);
  EXPECT_LT(without, workflow::settling_time(period, 0, 1e-5));
}

recipe::Recipe elastic(const std::string& stages) {
  return recipe::parse_recipe(test::small_packing_recipe + "[contact]\nrestitution = 1\nfriction = 0\n" + stages,
                              "recipe.toml");
}

TEST(Prediction, TheStepOfUndampedGrainsIsATenthOfTheShortestCollision) {
  const auto p =
      workflow::predict(elastic("[[stages]]\nname = \"shear\"\nright = { pressure = \"20 kPa\" }\ntop = { velocity = "
                                "\"10 mm/s\" }\nduration = \"10 ms\"\n"));
  EXPECT_EQ(p.limit, workflow::StepLimit::collision);
  EXPECT_NEAR(p.time_step, 0.1 * p.collision.time, 1e-15);
  EXPECT_EQ(p.grains, 60u);
  ASSERT_EQ(p.stages.size(), 1u);
  EXPECT_TRUE(p.stages[0].exact);
  EXPECT_EQ(p.stages[0].steps, dem::steps_of(0.01, p.time_step));
  EXPECT_EQ(p.stages[0].pressure, 20e3);
  EXPECT_NEAR(*p.stages[0].stiffness_number, 27.35e6 / (20e3 * 0.06), 1e-3);
  EXPECT_GT(*p.stages[0].inertial_number, 0);
  EXPECT_TRUE(p.warnings.empty());
}

TEST(Prediction, WarnsOfSoftGrainsFastSidesAndTinySteps) {
  auto recipe = elastic(
      "[[stages]]\nname = \"press\"\nright = { pressure = \"20 MPa\" }\ntop = { pressure = \"20 MPa\" }\n"
      "[[stages]]\nname = \"slam\"\nright = { pressure = \"1 Pa\" }\ntop = { velocity = \"1 m/s\" }\nduration = \"1 "
      "ms\"\n");
  recipe.integration.time_step = 1e-9;
  const auto p = workflow::predict(recipe);
  EXPECT_EQ(p.limit, workflow::StepLimit::given);
  const auto warns = [&](const std::string& of) {
    return std::any_of(p.warnings.begin(), p.warnings.end(),
                       [&](const std::string& w) { return w.find(of) != std::string::npos; });
  };
  EXPECT_TRUE(warns("a collision takes"));
  EXPECT_TRUE(warns("stage press: grains overlap"));
  EXPECT_TRUE(warns("stage slam: I ="));
  EXPECT_FALSE(p.stages[0].exact);
  EXPECT_GT(p.stages[0].steps, 0);
}

TEST(Prediction, OfProgrammesAndCyclesOfStrainKnowsWhatTheyAskFor) {
  const auto p = workflow::predict(elastic(
      "[[stages]]\nname = \"ramp\"\nright = { pressure = \"20 kPa\" }\nduration = \"10 ms\"\n"
      "[[stages.programmes]]\nof = \"top.pressure\"\ntable = [[\"0 s\", \"1 kPa\"], [\"5 ms\", \"300 kPa\"], [\"10 "
      "ms\", \"2 kPa\"]]\n"
      "[[stages]]\nname = \"cycle\"\nstrain_cycles = { of = \"top\", max = 0.01, rate = \"2 1/s\", count = 30 }\n"));
  EXPECT_EQ(p.stages[0].pressure, 300e3);
  EXPECT_TRUE(p.stages[1].exact);
  // 60 half cycles of 5 ms, each rounded up to whole steps.
  EXPECT_NEAR(p.stages[1].duration, 0.3, 60 * p.time_step);
  EXPECT_EQ(p.stages[1].steps, 60 * dem::steps_of(0.005, p.time_step));
}

TEST(Prediction, OfALargeSampleLooksAtASmallOneOfTheSameKind) {
  auto recipe = elastic(
      "[[stages]]\nname = \"shear\"\nright = { pressure = \"20 kPa\" }\ntop = { velocity = \"10 mm/s\" }\nduration = "
      "\"10 ms\"\n");
  const auto small = workflow::predict(recipe);
  recipe.populations[0].count = 60'000;
  recipe.container.width *= std::sqrt(1000.0);
  const auto large = workflow::predict(recipe);
  EXPECT_EQ(large.grains, 60'000u);
  EXPECT_LT(large.sample, 5'000u);
  EXPECT_NEAR(large.time_step / small.time_step, 1, 0.05);
}

}  // namespace
}  // namespace arenite
