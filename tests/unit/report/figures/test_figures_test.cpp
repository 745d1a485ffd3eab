#include "report/figures/test_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "report/figures/cycle_figures.hpp"
#include "support/sheared_spheres.hpp"

using namespace arenite;
using namespace arenite::report::figures;

namespace {

/// A box of 4 by 4 that is pressed from above, so many rows.
StageResult pressed(std::size_t rows, bool sides_give_way, double lateral = 40) {
  StageResult stage;
  stage.name = "press";
  std::vector<double> time, width, height;
  for (std::size_t k = 0; k < rows; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(rows - 1);
    time.push_back(share);
    height.push_back(4 - 0.4 * share);
    width.push_back(4 + (sides_give_way ? 0.2 * share : 0));
  }
  const auto add = [&](const std::string& name, std::vector<double> values) {
    stage.history.columns.push_back({name, "", std::move(values)});
  };
  add("time", time);
  add("left_position", std::vector<double>(rows, 0)), add("right_position", width);
  add("bottom_position", std::vector<double>(rows, 0)), add("top_position", height);
  for (const char* side : {"left", "right"}) add(std::string(side) + "_force", std::vector<double>(rows, lateral));
  for (const char* side : {"bottom", "top"}) add(std::string(side) + "_force", std::vector<double>(rows, 120));
  stage.snapshots.resize(1);
  stage.snapshots[0].time = 0.5;
  Packing& packing = stage.snapshots[0].packing;
  packing.domain.wall[right].position = 4.1;
  packing.domain.wall[top].position = 3.8;
  packing.domain.thickness = 0.1;
  packing.grains.resize(1);
  packing.grains.radius[0] = 1;
  return stage;
}

StageData data_of(const StageResult& stage) { return {stage, {&stage.snapshots[0]}}; }

TEST(TestFigures, RatioAndVolumeStandSideBySideAgainstTheStrainOfTheSides) {
  const StageResult stage = pressed(5, true);
  const auto panels = test_curves(data_of(stage)).front().panels;
  ASSERT_EQ(panels.size(), 2u);
  EXPECT_EQ(panels[0].x.unit, "%");
  EXPECT_NEAR(panels[0].series[0].x.back(), 10, 1e-12);
  const double xx = 40 / 3.6, yy = 120 / 4.2;
  EXPECT_NEAR(panels[0].series[0].y.back(), (yy - xx) / (yy + xx), 1e-12);
  EXPECT_EQ(panels[1].y.label, "volumetric strain");
  EXPECT_NEAR(panels[1].series[0].y.back(), 100 * (1 - 3.6 * 4.2 / 16), 1e-9);
  EXPECT_NEAR(panels[0].now.x[0], 5, 1e-12);
}

TEST(TestFigures, WithFixedSidesTheStressesAlongTheAxisAndAcrossItStandInPlaceOfTheVolume) {
  const StageResult stage = pressed(5, false);
  const auto panels = test_curves(data_of(stage)).front().panels;
  ASSERT_EQ(panels[0].series.size(), 2u);
  EXPECT_EQ(panels[0].series[0].name, "along the axis");
  EXPECT_NEAR(panels[0].series[0].y.back(), 120 / 0.4, 1e-9);
  EXPECT_NEAR(panels[0].series[1].y.back(), 40 / 0.36, 1e-9);
  EXPECT_EQ(panels[1].y.brief, "q/p");
  EXPECT_NEAR(panels[0].now.x[0], 5, 1e-12);
}

TEST(TestFigures, WithoutConfinementTheStressStandsAlone) {
  const StageResult stage = pressed(5, false, 0);
  const auto panels = test_curves(data_of(stage)).front().panels;
  ASSERT_EQ(panels.size(), 1u);
  EXPECT_EQ(panels[0].y.label, "stress along the axis");
  EXPECT_EQ(panels[0].y.unit, "Pa");
}

TEST(TestFigures, OfARockStrengthModulusAndBrokenBondsAreShown) {
  StageResult stage = pressed(5, false, 0);
  const std::vector<double> force{0, 60, 120, 30, 20};
  for (auto& column : stage.history.columns)
    if (column.name == "bottom_force" || column.name == "top_force") column.values = force;
  stage.history.columns.push_back({"broken_in_tension", "1", {0, 0, 1, 7, 8}});
  const Drawing drawing = test_curves(data_of(stage)).front();
  ASSERT_EQ(drawing.panels.size(), 2u);
  const Reference& strength = drawing.panels[0].references.back();
  EXPECT_EQ(strength.label, "strength");
  EXPECT_NEAR(*strength.x, 5, 1e-12);
  EXPECT_NEAR(*strength.y, 120 / 0.4, 1e-9);
  EXPECT_EQ(drawing.panels[1].series[0].y.back(), 8);
  EXPECT_EQ(drawing.panels[1].series[0].colour, "broken 0");  // as the cracks in the picture
  EXPECT_NEAR(drawing.panels[1].now.x[0], 5, 1e-12);
  EXPECT_EQ(drawing.key.front().numbers.front().value, "300.0\u202fPa");
}

TEST(TestFigures, ManyRowsArePaleUnderTheirRunningMeanWhichKeepsWhatIsStraight) {
  const std::size_t rows = 1001;
  std::vector<double> x, y;
  for (std::size_t k = 0; k < rows; ++k) {
    x.push_back(static_cast<double>(k));
    y.push_back(2 * x.back() + (k % 2 == 0 ? 5 : -5));
  }
  Panel panel;
  add_curve(panel, x, y, "strong");
  ASSERT_EQ(panel.series.size(), 2u);
  EXPECT_FALSE(panel.series[0].is_read);
  EXPECT_EQ(panel.series[0].y, y);
  for (std::size_t k = 20; k + 20 < rows; ++k) EXPECT_NEAR(panel.series[1].y[k], 2 * x[k], 1);
}

TEST(TestFigures, OneCurveAgainstAnotherHasTheUnitsOfBothAndThePlaceOfEachState) {
  const StageResult stage = pressed(5, true);
  const Panel panel = one_against_another(data_of(stage), "axial_strain", "sigma_yy");
  EXPECT_EQ(panel.x.label + ", " + panel.x.unit, "axial strain, %");
  EXPECT_EQ(panel.y.label, "\u03c3_{yy}");
  EXPECT_NEAR(panel.now.x[0], 5, 1e-12);
  EXPECT_THROW(one_against_another(data_of(stage), "axial_strain", "beauty"), InputError);
  EXPECT_EQ(one_against_another(data_of(stage), "test", "test").y.label, "q/p");
}

TEST(TestFigures, TheTestOfShearedSpheresIsTheirFrictionAgainstTheShearStrain) {
  SphereResult sheared = test::cube_of_spheres(2);
  test::shear_the_cell(sheared, 0.01);
  sheared.snapshots.back().time = 200;
  const Panel panel = one_against_another(sheared, "test", "test").value();
  EXPECT_EQ(panel.x.label, "shear strain");
  EXPECT_EQ(panel.y.label, "\u03bc");
  EXPECT_NEAR(panel.now.x.front(), 200, 1e-9);  // per cent
  EXPECT_NEAR(panel.now.y.front(), 0.4, 0.01);
}

TEST(TestFigures, CyclesShowBothEndsOfTheLoad) {
  StageResult stage = pressed(5, true);
  EXPECT_TRUE(cycles(data_of(stage)).empty());
  for (const auto& column : stage.history.columns) {
    std::vector<double> ends;
    for (int k = 0; k < 8; ++k) ends.push_back(column.values[static_cast<std::size_t>(k % 2 == 0 ? 4 : 2)]);
    stage.cycles.columns.push_back({column.name, column.unit, ends});
  }
  stage.cycles.columns.push_back({"cycle", "", {1, 1, 2, 2, 3, 3, 4, 4}});
  const auto drawing = cycles(data_of(stage)).front();
  EXPECT_EQ(drawing.panels[0].series[0].x, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_NEAR(drawing.panels[0].series[0].y[3], 10, 1e-9);
  EXPECT_NEAR(drawing.panels[0].series[1].y[3], 5, 1e-9);
  ASSERT_EQ(drawing.panels.size(), 2u);
  EXPECT_EQ(drawing.panels[1].series[0].y.size(), 5u);
  EXPECT_EQ(drawing.panels[1].series[1].name, "last cycle");
  EXPECT_NEAR(drawing.panels[1].now.x[0], 5, 1e-12);
  EXPECT_NEAR(drawing.panels[1].now.y[0], 120 / 0.41, 1e-9);
  EXPECT_EQ(drawing.key.size(), 3u);
}

}  // namespace
