#include "report/figures/stage_figures.hpp"

#include <gtest/gtest.h>

using namespace arenite;
using namespace arenite::report::figures;

TEST(StageFigures, TheMassThatHasPassedIsDrawnOverTheTime) {
  StageResult stage;
  stage.history.columns = {{"time", "s", {2.0, 2.5, 3.0}}, {"passed_mass", "kg", {0, 0.2, 0.4}}};
  const auto& row = *std::ranges::find(stage_figures(), "discharge", [](const auto& r) { return r.head.id; });
  const Panel panel = row.draw({stage, {}}).front().panels.front();
  EXPECT_EQ(panel.series[0].x, (std::vector<double>{0, 0.5, 1}));
  EXPECT_NEAR(panel.series[0].y[1], 200, 1e-9);
  EXPECT_EQ(panel.y.label, "mass passed");
  EXPECT_EQ(panel.y.unit, "g");
}

TEST(StageFigures, ForcesOfOppositeWallsAreToldApartWhereTheyAreEqual) {
  StageResult stage;
  stage.name = "press";
  stage.history.columns = {
      {"time", "s", {0, 1, 2}}, {"bottom_force", "N", {0, 1e3, 2e3}}, {"top_force", "N", {0, 1e3, 2e3}}};
  const auto& row = *std::ranges::find(stage_figures(), "wall-forces", [](const auto& r) { return r.head.id; });
  const Drawing drawing = row.draw({stage, {}}).front();
  EXPECT_EQ(drawing.panels[0].y.unit, "kN");
  EXPECT_EQ(drawing.panels[0].series[1].y, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(drawing.panels[0].series[0].line, Line::solid);
  EXPECT_EQ(drawing.panels[0].series[1].line, Line::dashed);
  EXPECT_EQ(drawing.key[1].line, Line::dashed);
}

TEST(StageFigures, TheForcesOnBoundariesThatAreThereAreDrawnOverTheTime) {
  StageResult stage;
  Snapshot state;
  auto& boundaries = state.packing.domain.boundaries;
  boundaries.resize(2);
  boundaries[0].name = "post", boundaries[1].name = "gate", boundaries[1].present = false;
  stage.snapshots.push_back(state);
  stage.history.columns = {
      {"time", "s", {0, 1, 2}}, {"post_force_y", "N", {0, -0.1, -0.2}}, {"gate_force_y", "N", {1, 1, 1}}};
  const auto& row = *std::ranges::find(stage_figures(), "boundary-forces", [](const auto& r) { return r.head.id; });
  const Drawing drawing = row.draw({stage, {}}).front();
  ASSERT_EQ(drawing.key.size(), 1u);
  EXPECT_EQ(drawing.key[0].name, "post, y");
  EXPECT_EQ(drawing.panels[0].y.unit, "mN");
  EXPECT_NEAR(drawing.panels[0].series[0].y[2], -200, 1e-9);
  stage.snapshots.back().packing.domain.boundaries.front().present = false;
  EXPECT_TRUE(row.draw({stage, {}}).empty());
}
