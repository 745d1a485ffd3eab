#include "grains/fields/stage_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace arenite::fields {
namespace {

/// Nine equal disks in three rows of three, joined to their neighbours, in a cell that the sides press by 100 Pa.
Packing grid() {
  Packing p;
  p.materials = {{"glass", 2500, 1e6, 0}};
  p.domain.thickness = 0.1;
  p.domain.wall[right].position = p.domain.wall[top].position = 0.03;
  p.domain.wall[right].force = p.domain.wall[top].force = 100 * 0.03 * 0.1;
  p.grains.resize(9);
  for (std::size_t g = 0; g < 9; ++g) p.grains.radius[g] = 0.005;
  for (std::int32_t g = 0; g < 9; ++g) {
    if (g % 3 < 2) p.cohesive.push_back({g, g + 1, -1e-6, 0.4, 0});
    if (g < 6) p.cohesive.push_back({g, g + 3, g == 0 ? 1e-4 : -1e-6, g == 0 ? 0.3 : 0.4, 0});
  }
  return p;
}

StageResult drawn() {
  StageResult r;
  r.snapshots.push_back({1, 1000, "end", grid(), {}, {}});
  r.snapshots.back().packing.cohesive.resize(5);
  const std::vector<double> zero(4, 0.0), wide(4, 0.03);
  r.history.columns = {
      {"left_position", "m", zero}, {"right_position", "m", wide}, {"top_force", "N", {0.3, -0.6, -0.45, -0.1}}};
  return r;
}

dem::Stage drawing_the_top() {
  dem::Stage stage;
  stage.side[top] = {dem::SideDrive::Kind::velocity, -0.01};
  return stage;
}

TEST(CohesionNumbers, TellStrengthBesideRumpfsEstimate) {
  const Packing before = grid();
  const Numbers n = cohesion_numbers({drawn(), drawing_the_top(), &before, {}})["cohesion"];
  EXPECT_EQ(n["pairs"].get<int>(), 5);
  EXPECT_EQ(n["pairs_apart"].get<int>(), 1);
  EXPECT_NEAR(n["pull_N"].get<double>(), 0.4, 1e-12);
  EXPECT_NEAR(n["bond_number"].get<double>(), 0.4 / (100 * 0.01 * 0.1), 1e-12);
  EXPECT_NEAR(n["tensile_strength_Pa"].get<double>(), 0.6 / (0.03 * 0.1), 1e-9);
  EXPECT_NEAR(n["tensile_strength_over_pressure"].get<double>(), 2, 1e-12);
  const double fraction = 9 * std::numbers::pi * 0.005 * 0.005 / (0.03 * 0.03), neighbours = 2 * 12.0 / 9;
  EXPECT_NEAR(n["rumpf_Pa"].get<double>(), fraction * neighbours * 0.4 / (std::numbers::pi * 0.01 * 0.1), 1e-9);
}

TEST(CohesionNumbers, SetThePullBesideTheWeightUnderGravity) {
  dem::Stage stage;
  stage.gravity = true;
  const Packing before = grid();
  const Numbers n = cohesion_numbers({drawn(), stage, &before, {}})["cohesion"];
  EXPECT_NEAR(n["bond_number"].get<double>(), 0.4 / (2500 * std::numbers::pi * 0.005 * 0.005 * 0.1 * 9.81), 1e-9);
  EXPECT_FALSE(n.contains("tensile_strength_Pa"));
}

TEST(CohesionNumbers, SayNothingOfDryGrains) {
  StageResult dry = drawn();
  dry.snapshots.back().packing.cohesive.clear();
  Packing before = grid();
  before.cohesive.clear();
  EXPECT_TRUE(cohesion_numbers({dry, drawing_the_top(), &before, {}}).empty());
}

}  // namespace
}  // namespace arenite::fields
