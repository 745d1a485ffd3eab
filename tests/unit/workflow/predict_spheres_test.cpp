#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "grains/dem/run_stage.hpp"
#include "workflow/predict.hpp"

namespace arenite {
namespace {

recipe::Recipe of_spheres(int count, const std::string& more) {
  return recipe::parse_recipe(R"(dimension = 3
[materials.glass]
density = "2500 kg/m^3"
stiffness = "100 kN/m"
[[populations]]
material = "glass"
count = )" + std::to_string(count) +
                                  R"(
diameter = "4 mm"
[container]
width = "20 mm"
depth = "20 mm"
)" + more,
                              "r.toml");
}

const std::string press_and_shear = R"([[stages]]
name = "press"
top = { force = "4 N" }
increments = 3
[[stages]]
name = "slide"
top = { pressure = "10 kPa" }
slide = { top = "10 mm/s" }
duration = "5 ms"
snapshots = 4
)";

TEST(PredictionOfSpheres, CountsStepsStatesFilesAndMemory) {
  const auto p = workflow::predict(of_spheres(150, press_and_shear));
  EXPECT_EQ(p.grains, 150u);
  EXPECT_EQ(p.sample, 150u);
  ASSERT_EQ(p.stages.size(), 2u);
  const fields::StagePrediction &press = p.stages[0], &slide = p.stages[1];
  EXPECT_FALSE(press.exact);
  EXPECT_EQ(press.states, 3);
  EXPECT_GT(press.steps, press.increment_steps);
  EXPECT_TRUE(slide.exact);
  EXPECT_EQ(slide.states, 4);
  EXPECT_EQ(slide.steps, dem::steps_of(5e-3, p.time_step));
  EXPECT_NEAR(slide.seconds / static_cast<double>(slide.steps), p.seconds_per_step, 1e-9 * p.seconds_per_step);
  EXPECT_GT(p.bytes(), 7 * 150 * 8 * 10.) << "seven states, ten numbers of each sphere";
  EXPECT_GT(p.memory, 150 * 8 * 20.);
}

TEST(PredictionOfSpheres, OfALargeSampleLooksAtASmallOneWithoutItsBoundaries) {
  const std::string hopper = R"(height = "400 mm"
[packing]
area = { bottom = "30 mm", top = "380 mm" }
[[boundaries]]
name = "floor"
plate = { y = "20 mm" }
[[stages]]
name = "fall"
gravity = true
duration = "1 ms"
boundaries = [{ name = "floor", velocity = ["0 mm/s", "1 mm/s", "0 mm/s"] }]
)";
  const auto small = workflow::predict(of_spheres(1000, hopper));
  recipe::Recipe large = of_spheres(1000, hopper);
  const double wider = std::sqrt(1000.0);
  large.populations[0].count = 1'000'000;
  large.container.width *= wider;
  large.container.depth *= wider;
  const auto p = workflow::predict(large);
  EXPECT_EQ(p.grains, 1'000'000u);
  EXPECT_LT(p.sample, 5'000u);
  EXPECT_NEAR(p.time_step / small.time_step, 1, 0.05);
  EXPECT_NEAR(p.memory, 2.5e9, 0.5e9);
  EXPECT_GT(p.seconds(), 100 * small.seconds());
}

TEST(PredictionOfSpheres, WhatHasComeToRestIsDense) {
  const auto first = workflow::predict(of_spheres(150, R"([[stages]]
name = "press"
top = { pressure = "10 kPa" }
[[stages]]
name = "again"
top = { pressure = "10 kPa" }
)"));
  EXPECT_LT(first.stages[1].steps, first.stages[0].steps);
  EXPECT_GT(first.stages[1].steps, 0);
}

}  // namespace
}  // namespace arenite
