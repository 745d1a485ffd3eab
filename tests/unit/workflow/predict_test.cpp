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

recipe::Recipe elastic(const std::string& stages) {
  return recipe::parse_recipe(test::small_packing_recipe + "[contact]\nrestitution = 1\nfriction = 0\n" + stages,
                              "recipe.toml");
}

TEST(Prediction, TheStepOfUndampedGrainsIsATenthOfTheShortestCollision) {
  const auto p =
      workflow::predict(elastic("[[stages]]\nname = \"shear\"\nright = { pressure = \"20 kPa\" }\ntop = { velocity = "
                                "\"10 mm/s\" }\nduration = \"10 ms\"\n"));
  EXPECT_EQ(p.limit, fields::StepLimit::collision);
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
  EXPECT_EQ(p.limit, fields::StepLimit::given);
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

TEST(Prediction, RefusesStagesOfMoreStepsThanCanBeCounted) {
  auto recipe = elastic("[[stages]]\nname = \"wait\"\ntop = { pressure = \"1 Pa\" }\nduration = \"1e8 s\"\n");
  recipe.integration.time_step = 1e-9;
  try {
    workflow::predict(recipe);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("stage \"wait\": 1e+08 s are 1e+17 steps of 1e-09 s"), std::string::npos)
        << error.what();
  }
  recipe.stages[0].duration.reset();  // an estimate is no more than can be counted
  recipe.integration.time_step = 1e-30;
  EXPECT_GT(workflow::predict(recipe).stages[0].steps, 0);
}

TEST(Prediction, KnowsStrainHeightStatesAndFilesFromWhatIsAsked) {
  const auto p = workflow::predict(
      elastic("[[stages]]\nname = \"press\"\nright = { pressure = \"20 kPa\" }\ntop = { velocity = \"10 mm/s\" }\n"
              "duration = \"1 s\"\nsnapshots = 7\n"
              "[[stages]]\nname = \"sink\"\nbottom = { velocity = \"-5 mm/s\" }\nduration = \"1 s\"\n"));
  const fields::StagePrediction &press = p.stages[0], &sink = p.stages[1];
  const double before = *press.height / (1 - *press.strain);
  EXPECT_NEAR(before - *press.height, 0.01, 1e-12) << "way of the top";
  EXPECT_NEAR(*sink.height - *press.height, 0.005, 1e-12);
  EXPECT_NEAR(*sink.strain, -0.005 / *press.height, 1e-12);
  EXPECT_EQ(press.states, 7);
  EXPECT_EQ(sink.states, 1);
  EXPECT_GT(p.bytes(), 9 * 60 * 8 * 10.) << "nine states of sixty grains, ten numbers of each";
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

TEST(Prediction, OfATallSampleLooksAtOneThatIsWideEnoughForItsGrains) {
  auto recipe = elastic("[[stages]]\nname = \"press\"\ntop = { pressure = \"20 kPa\" }\nduration = \"10 ms\"\n");
  recipe.populations[0].count = 1'000'000;  // 100 mm wide, and more than a kilometre high
  const auto tall = workflow::predict(recipe);
  EXPECT_EQ(tall.grains, 1'000'000u);
  const double area = 1e6 * std::numbers::pi / 4 * (0.013 * 0.013 + 0.006 * 0.006 / 12);  // of uniform diameters
  EXPECT_NEAR(*tall.stages[0].height * 0.1 * 0.78 / area, 1, 0.02) << "of some thousand drawn grains";
}

}  // namespace
}  // namespace arenite
