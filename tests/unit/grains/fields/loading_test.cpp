#include "grains/fields/loading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "grains/fields/state_curves.hpp"

namespace arenite::fields {
namespace {

Packing box(double width, double height) {
  Packing packing;
  packing.materials = {{"clay", 1000, 1e6, 0}};
  for (const Vec2 place : {Vec2{1, 1}, {3, 1}, {1, 3}, {3, 3}}) {
    packing.grains.resize(packing.grains.size() + 1);
    packing.grains.position.back() = place;
    packing.grains.radius.back() = 1;
  }
  packing.domain.wall[right].position = width;
  packing.domain.wall[top].position = height;
  packing.domain.thickness = 0.1;
  return packing;
}

/// A box whose top goes down and whose sides give way, under pressures of 40 N and 120 N on its sides.
StageResult biaxial() {
  StageResult stage;
  stage.name = "test";
  const std::vector<double> width{4, 4.1, 4.2}, height{4, 3.8, 3.6};
  const auto add = [&](const char* name, std::vector<double> values) {
    stage.history.columns.push_back({name, "", std::move(values)});
  };
  add("time", {1, 2, 4});
  add("left_position", {0, 0, 0}), add("right_position", width);
  add("bottom_position", {0, 0, 0}), add("top_position", height);
  for (const char* side : {"left", "right"}) add((std::string(side) + "_force").c_str(), {40, 40, 40});
  for (const char* side : {"bottom", "top"}) add((std::string(side) + "_force").c_str(), {120, 120, 120});
  for (std::size_t k = 0; k < 3; ++k) {
    stage.snapshots.emplace_back();
    stage.snapshots.back().time = std::vector<double>{1, 2, 4}[k];
    stage.snapshots.back().packing = box(width[k], height[k]);
  }
  return stage;
}

TEST(Loading, StrainsAreThoseSinceTheStateBeforeAndStressesThoseOfTheSides) {
  const StageResult stage = biaxial();
  const Packing before = box(4, 4.1);
  const auto of = loading_of({stage, &before});
  ASSERT_TRUE(of);
  EXPECT_NEAR(of->curves["axial_strain"][2], 1 - 3.6 / 4.1, 1e-12);
  EXPECT_NEAR(of->curves["strain_x"][2], 1 - 4.2 / 4, 1e-12);
  EXPECT_NEAR(of->curves["volumetric_strain"][2], 1 - 3.6 * 4.2 / (4 * 4.1), 1e-12);
  const double xx = 40 / (3.6 * 0.1), yy = 120 / (4.2 * 0.1);
  EXPECT_NEAR(of->curves["q_over_p"][2], (yy - xx) / (yy + xx), 1e-12);
  EXPECT_NEAR(of->curves["solid_fraction"][0], 4 * std::numbers::pi / 16, 1e-12);
  EXPECT_FALSE(of->sheared || of->uniaxial || of->curves.has("mu") || of->curves.has("dissipated_energy"));
  for (const auto& column : of->curves.list) {
    EXPECT_FALSE(column.meaning.sentence.empty()) << column.name;
    EXPECT_EQ(column.values.size(), 3u) << column.name;
  }
}

TEST(Loading, TheRateOfShearIsOfTheSecondOrderWhereRowsAreUneven) {
  StageResult stage = biaxial();
  std::vector<double> parabola;
  for (const double t : {1.0, 2.0, 4.0}) parabola.push_back(t * t);
  stage.history.columns.push_back({"shear_strain", "1", parabola});
  const auto of = loading_of({stage});
  ASSERT_TRUE(of && of->sheared);
  const double yy = 120 / (4.1 * 0.1);
  EXPECT_NEAR(of->curves["inertial_number"][1], 4 * 2 * std::sqrt(1000 / yy), 1e-9);
  EXPECT_EQ(of->curves["shear_strain"][2], 15);
}

TEST(Loading, AStageWithoutAHistoryHasNone) { EXPECT_FALSE(loading_of({StageResult{}})); }

TEST(Loading, StatesHaveTheStrainsOfTheHistory) {
  const StageResult stage = biaxial();
  const auto rows = loading_of({stage})->curves, states = curves_of_states({stage});
  for (const char* name : {"axial_strain", "shear_strain", "volumetric_strain"})
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(states[name][k], rows[name][k], 1e-12) << name;
}

TEST(Loading, CyclesOfATableAreReadAtBothEnds) {
  StageResult stage = biaxial();
  stage.asked.known = true;
  stage.asked.cycled = top;
  stage.cycles = stage.history;
  stage.cycles.columns.push_back({"cycle", "1", {1, 1, 2}});
  const auto found = every_cycle({stage});
  EXPECT_EQ(found["cycle"], std::vector<double>{1});
  EXPECT_NEAR(found["axial_strain_minimum"][0], 0.05, 1e-12);
  EXPECT_NEAR(found["accumulated_strain"][0], 0, 1e-12);
  EXPECT_THROW(every_cycle({biaxial()}), InputError);
  EXPECT_THROW(curves_of_cycles({biaxial()}), InputError);
}

}  // namespace
}  // namespace arenite::fields
