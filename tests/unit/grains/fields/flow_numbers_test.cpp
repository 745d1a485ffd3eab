#include "grains/fields/driven.hpp"
#include "grains/fields/stage_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace arenite::fields {
namespace {

/// A column of disks three wide, or what became of it: a ramp to the right.
Packing column(bool fallen) {
  Packing p;
  p.materials = {{"glass", 2500, 1e6, 0}};
  for (int c = 0; c < (fallen ? 60 : 20); ++c)
    for (int r = 0; r < (fallen ? 30 - c / 2 : 40); ++r) {
      p.grains.resize(p.grains.size() + 1);
      p.grains.position.back() = {0.01 * (c + 0.5), 0.01 * (r + 0.5)};
      p.grains.radius.back() = 0.005;
    }
  return p;
}

StageResult result() {
  StageResult r;
  r.snapshots.push_back({1, 1000, "end", column(true), {}, {}});
  r.asked.known = true;
  r.asked.gravity = {0, -dem::standard_gravity};
  std::vector<double> time, grains, mass;
  for (int k = 0; k <= 400; ++k) {
    time.push_back(0.01 * k);
    grains.push_back(std::max(0, 5 * (k - 50) + k * k % 7));
    mass.push_back(0.002 * grains.back());
  }
  r.history.columns = {{"time", "s", time}, {"passed", "1", grains}, {"passed_mass", "kg", mass}};
  return r;
}

TEST(FlowNumbers, TellDischargeAngleAndRunOut) {
  dem::Stage stage;
  stage.gravity = true;
  const Packing before = column(false);
  const Numbers n = flow_numbers({result(), stage, &before, {}});
  EXPECT_NEAR(n["discharge"]["rate_grains_s"]["value"].get<double>(), 500, 5);
  EXPECT_NEAR(n["discharge"]["rate_kg_s"]["value"].get<double>(), 1, 0.01);
  EXPECT_TRUE(n["discharge"]["steady"].get<bool>());
  EXPECT_FALSE(n["discharge"].contains("opening_m"));
  const Numbers& surface = n["surface"];
  EXPECT_NEAR(surface["angle_deg"]["value"].get<double>(), 26.57, 0.5);
  EXPECT_NEAR(surface["runout_m"]["value"].get<double>(), 0.4, 1e-9);
  EXPECT_NEAR(surface["runout_m"]["error"].get<double>(), 0.005, 1e-12);
  EXPECT_NEAR(surface["runout_over_width"]["value"].get<double>(), 2, 1e-9);
  EXPECT_NEAR(surface["aspect_ratio_before"].get<double>(), 2, 0.01);
}

TEST(FlowNumbers, ARunOutThatAWallStoppedHasNoErrorAndSaysSo) {
  dem::Stage stage;
  stage.gravity = true;
  const Packing before = column(false);
  StageResult stopped = result();
  stopped.snapshots.back().packing.domain.wall[right].position = 0.602;
  const Numbers n = flow_numbers({stopped, stage, &before, {}});
  EXPECT_NEAR(n["surface"]["runout_m"]["value"].get<double>(), 0.4, 1e-9);
  EXPECT_FALSE(n["surface"]["runout_m"]["error"].is_number());
  EXPECT_EQ(n["surface"]["notes"].size(), 1u);
}

TEST(FlowNumbers, GrainsThatFallSinglyAreNoHeap) {
  dem::Stage stage;
  stage.gravity = true;
  const Packing before = column(false);
  StageResult empty = result();
  for (int i = 0; Vec2 & place : empty.snapshots.back().packing.grains.position) place.y -= 0.05 * ++i;
  const Numbers n = flow_numbers({empty, stage, &before, {}});
  EXPECT_FALSE(n["surface"].contains("left_m"));
  EXPECT_FALSE(n["surface"].contains("runout_m"));
  ASSERT_EQ(n["surface"]["notes"].size(), 1u);
  EXPECT_NE(n["surface"]["notes"][0].get<std::string>().find("which are no heap"), std::string::npos);
}

TEST(FlowNumbers, OfADrumAreNoRunOut) {
  StageResult drum = result();
  Boundary round;
  round.name = "drum", round.closed = true, round.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  drum.snapshots.back().packing.domain.boundaries = {round};
  dem::Stage stage;
  stage.gravity = true;
  const Packing before = column(false);
  EXPECT_TRUE(flow_numbers({drum, stage, &before, {}})["surface"].contains("runout_m")) << "it stands still";
  drum.snapshots.back().packing.domain.boundaries.front().spin = 1;
  const Numbers surface = flow_numbers({drum, stage, &before, {}})["surface"];
  EXPECT_TRUE(surface.contains("angle_deg"));
  for (const char* name : {"runout_m", "runout_over_width", "aspect_ratio_before", "width_before_m"})
    EXPECT_FALSE(surface.contains(name)) << name;
}

/// A force of -3 N with fluctuations while the grains pass, of -50 N before and of none after.
StageResult with_obstacle() {
  StageResult flow = result();
  auto& boundaries = flow.snapshots.back().packing.domain.boundaries;
  boundaries.resize(2);
  boundaries[0].name = "post", boundaries[1].name = "gate", boundaries[1].present = false;
  const auto& time = flow.history.columns[0].values;
  std::vector<double> force;
  for (std::size_t k = 0; k < time.size(); ++k)
    force.push_back(time[k] < 0.5 ? -50 : -3 + 0.2 * std::cos(2.4 * static_cast<double>(k)));
  for (const char* name : {"post_force_y", "gate_force_y"}) flow.history.columns.push_back({name, "N", force});
  return flow;
}

TEST(FlowNumbers, TellTheForceOnAnObstacleOverTheSteadyPartOfADischarge) {
  StageResult flow = with_obstacle();
  dem::Stage stage;
  stage.gravity = true;
  EXPECT_FALSE(flow_numbers({flow, stage, nullptr, {}}).contains("boundary_loads")) << "it ends at rest";
  stage.duration = 4;
  const Numbers loads = flow_numbers({flow, stage, nullptr, {}})["boundary_loads"];
  EXPECT_NEAR(loads["post"]["force_y_N"]["value"].get<double>(), -3, 0.01);
  EXPECT_GT(loads["post"]["force_y_N"]["error"].get<double>(), 0);
  EXPECT_LT(loads["post"]["force_y_N"]["error"].get<double>(), 0.02);
  EXPECT_FALSE(loads["post"].contains("force_x_N")) << "its history has none";
  EXPECT_FALSE(loads.contains("gate")) << "it is not there any more";
}

TEST(FlowNumbers, TellTheForceOnAnObstacleOfASteadyFlow) {
  StageResult flow = with_obstacle();
  std::erase_if(flow.history.columns, [](const auto& column) { return column.name.starts_with("passed"); });
  dem::Stage stage;
  stage.duration = 4;
  const Numbers loads = flow_numbers({flow, stage, nullptr, {}})["boundary_loads"];
  EXPECT_NEAR(loads["post"]["force_y_N"]["value"].get<double>(), -3, 0.01);
  auto& force = flow.history.columns.back().values = {};
  for (std::size_t k = 0; k < flow.history.columns[0].values.size(); ++k) force.push_back(static_cast<double>(k));
  flow.history.columns[1].values = force;
  EXPECT_FALSE(flow_numbers({flow, stage, nullptr, {}}).contains("boundary_loads")) << "it grows to the end";
}

TEST(FlowNumbers, OfALayerTellItsSolidFractionAwayFromFloorAndSurface) {
  StageResult layer = result();
  Packing& p = layer.snapshots.back().packing = {};
  p.materials = {{"glass", 2500, 1e6, 0}};
  for (int c = 0; c < 16; ++c)
    for (int r = 0; r < 20; ++r) {
      p.grains.resize(p.grains.size() + 1);
      p.grains.position.back() = {0.01 * (c + 0.5), 0.01 * (r + 0.5)};
      p.grains.radius.back() = 0.005;
    }
  p.domain.wall[right].position = 0.16, p.domain.wall[top].position = 1;  // the box is empty above
  dem::Stage stage;
  stage.gravity = true;
  const Numbers fraction = flow_numbers({layer, stage, nullptr, {}})["surface"]["solid_fraction"];
  EXPECT_NEAR(fraction["value"].get<double>(), std::numbers::pi / 4, 1e-9);  // of a square lattice
  EXPECT_NEAR(fraction["error"].get<double>(), 0, 1e-9);
  EXPECT_FALSE(flow_numbers({result(), stage, nullptr, {}})["surface"].contains("solid_fraction"));  // a ramp
}

TEST(FlowNumbers, TellTheFloorOfASilo) {
  StageResult silo = result();
  silo.history.columns.resize(1);
  const std::size_t rows = silo.history.columns[0].values.size();
  for (const auto& [name, force] : {std::pair{"bottom_force", 60.0}, {"left_force", 50.0}, {"right_force", 50.0}}) {
    silo.history.columns.push_back({name, "N", std::vector<double>(rows, force)});
    for (std::size_t k = 0; k < rows; ++k)
      silo.history.columns.back().values[k] += (k < rows / 3 ? 100 : 0.5 * std::cos(2.4 * static_cast<double>(k)));
  }
  Packing& packing = silo.snapshots.back().packing;
  packing.domain.wall[right].position = 0.6;
  packing.domain.thickness = 0.1;
  dem::Stage stage;
  stage.gravity = true;
  stage.duration = 4;
  const Numbers floor = flow_numbers({silo, stage, nullptr, {}})["floor"];
  EXPECT_NEAR(floor["pressure_Pa"]["value"].get<double>(), 1000, 2);
  EXPECT_LT(floor["pressure_Pa"]["error"].get<double>(), 2);
  const double weight = 9.81 * 2500 * 0.1 * std::numbers::pi * 25e-6 * static_cast<double>(packing.grains.size());
  EXPECT_NEAR(floor["hydrostatic_Pa"].get<double>(), weight / 0.06, 1e-6 * weight / 0.06);
  EXPECT_NEAR(floor["wall_friction"].get<double>(), (weight - 60) / 100, 1e-2);
}

TEST(FlowNumbers, WeighTheFillingOfASiloByTheGravityThatActed) {
  StageResult silo = result();
  const std::size_t rows = silo.history.columns[0].values.size();
  for (const char* name : {"bottom_force", "left_force", "right_force"})
    silo.history.columns.push_back({name, "N", std::vector<double>(rows, 50.0)});
  Packing& packing = silo.snapshots.back().packing;
  packing.domain.wall[right].position = 0.6;
  packing.domain.thickness = 0.1;
  dem::Stage moon;
  moon.gravity = true;
  moon.gravity_size = 1.62;
  moon.duration = 4;
  silo.asked.gravity = {0, -1.62};
  const double mass = mass_of(packing);
  EXPECT_NEAR(flow_numbers({silo, moon, nullptr, {}})["floor"]["hydrostatic_Pa"].get<double>(), 1.62 * mass / 0.06,
              1e-9 * mass);
  // From 2 to 6 m/s^2: over the second half of 4 s the mean is 5.
  dem::Stage growing = moon;
  growing.programmes = {{{dem::Programme::What::gravity_size}, {{0, 2}, {4, 6}}}};
  silo.asked.gravity = {0, -6};
  add_driven(silo, growing);
  EXPECT_NEAR(flow_numbers({silo, growing, nullptr, {}})["floor"]["hydrostatic_Pa"].get<double>(), 5 * mass / 0.06,
              0.01 * mass / 0.06);
  dem::Stage turning = moon;
  turning.programmes = {{{dem::Programme::What::gravity_angle}, {{0, 0}, {4, 0.5}}}};
  silo.history.columns.resize(silo.history.columns.size() - 2);
  add_driven(silo, turning);
  EXPECT_FALSE(flow_numbers({silo, turning, nullptr, {}}).contains("floor")) << "it pulls aside";
}

TEST(FlowNumbers, AreNoneWithoutWeightAndUnderAPressingSide) {
  StageResult still = result();
  still.history = {};
  still.asked.gravity = {};
  dem::Stage stage;
  EXPECT_TRUE(flow_numbers({still, stage, nullptr, {}}).empty());
  still.asked.gravity = {0, -dem::standard_gravity};
  EXPECT_FALSE(flow_numbers({still, stage, nullptr, {}})["surface"].contains("runout_m"));
  stage.side[top] = {dem::SideDrive::Kind::force, 1};
  EXPECT_TRUE(flow_numbers({still, stage, nullptr, {}}).empty());
}

}  // namespace
}  // namespace arenite::fields
