#include "grains/fields/driven.hpp"

#include <gtest/gtest.h>

namespace arenite::fields {
namespace {

StageResult sampled() {
  StageResult result;
  result.history.columns = {{"time", "s", {3.5, 4, 5}}};
  result.cycles.columns = {{"time", "s", {4.5}}};
  return result;
}

TEST(Driven, WallsSlideAtTheirSpeedOrByTheIntegralOfTheirProgramme) {
  dem::Stage stage;
  stage.duration = 2;  // from 3 s on
  stage.slide[top] = 0.1;
  stage.programmes = {{{dem::Programme::What::slide, bottom}, {{0, 0}, {2, 2}}}};
  StageResult result = sampled();
  add_driven(result, stage);
  EXPECT_EQ(*result.history.find("top_slid"), (std::vector<double>{0.05, 0.1, 0.2}));
  EXPECT_EQ(*result.history.find("bottom_slid"), (std::vector<double>{0.125, 0.5, 2}));
  EXPECT_EQ(*result.cycles.find("bottom_slid"), std::vector<double>{1.125});
  EXPECT_FALSE(result.history.find("left_slid") || result.history.find("gravity_y"));
}

TEST(Driven, GravityIsThatOfItsProgrammeOrOfTheStage) {
  dem::Stage stage;
  stage.gravity = true;
  stage.duration = 2;
  stage.programmes = {{{dem::Programme::What::gravity_size}, {{0, 2}, {2, 6}}}};
  StageResult result = sampled();
  add_driven(result, stage);
  EXPECT_EQ(*result.history.find("gravity_y"), (std::vector<double>{-3, -4, -6}));
  EXPECT_EQ(gravity_in(result.history, result.asked)[1].y, -4);
  Asked still;
  still.gravity = {0, -1.62};
  EXPECT_EQ(gravity_in(sampled().history, still), std::vector<Vec2>(3, {0, -1.62}));
}

TEST(Driven, AStageThatDrivesNothingGetsNoColumns) {
  StageResult result = sampled();
  dem::Stage stage;
  stage.gravity = true;
  add_driven(result, stage);
  EXPECT_EQ(result.history.columns.size(), 1u);
}

}  // namespace
}  // namespace arenite::fields
