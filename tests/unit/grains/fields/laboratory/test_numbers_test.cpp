#include "grains/fields/laboratory/test_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "grains/fields/laboratory/axial_tests.hpp"
#include "grains/fields/laboratory/test_kind.hpp"

namespace arenite::fields {
namespace {

/// A box of 100 by 100 mm, 10 mm thick, in which nothing has happened yet.
StageResult box(std::size_t rows) {
  StageResult stage;
  stage.name = "press";
  Snapshot snapshot;
  snapshot.packing.grains.resize(1);
  snapshot.packing.grains.radius = {0.05};
  snapshot.packing.domain.thickness = 0.01;
  stage.snapshots.push_back(snapshot);
  for (const char* name :
       {"time", "left_position", "right_position", "bottom_position", "top_position", "left_force", "right_force",
        "bottom_force", "top_force", "broken_in_tension", "broken_in_bending", "broken_in_shear"})
    stage.history.columns.push_back({name, "", std::vector<double>(rows, 0.0)});
  return stage;
}

std::vector<double>& column(StageResult& stage, const std::string& name) {
  return std::ranges::find(stage.history.columns, name, &History::Column::name)->values;
}

/// Rises by 50 GPa to 100 MPa at 0.2 %, then falls to nothing at 0.4 %; a bond breaks with every row after the peak.
StageResult rock(double sign = 1) {
  StageResult stage = box(401);
  for (std::size_t k = 0; k <= 400; ++k) {
    const double strain = 1e-5 * static_cast<double>(k), stress = 50e9 * std::min(strain, 4e-3 - strain);
    column(stage, "time")[k] = static_cast<double>(k);
    column(stage, "right_position")[k] = 0.1;
    column(stage, "top_position")[k] = 0.1 * (1 - sign * strain);
    column(stage, "bottom_force")[k] = column(stage, "top_force")[k] = sign * stress * 0.1 * 0.01;
    column(stage, "broken_in_tension")[k] = std::max(0.0, static_cast<double>(k) - 200);
    column(stage, "broken_in_shear")[k] = k >= 100 ? 3 : 0;
  }
  return stage;
}

TEST(TestNumbers, OfARockAreStrengthModulusAndBrokenBonds) {
  for (const double sign : {1.0, -1.0}) {
    const StageResult stage = rock(sign);
    EXPECT_EQ(kind_of(fields::Test{stage}), TestKind::uniaxial);
    const Numbers found = test_numbers(fields::Test{stage});
    const Numbers& n = found["uniaxial"];
    EXPECT_NEAR(n["strength_Pa"].get<double>(), 100e6, 1);
    EXPECT_NEAR(n["strain_at_strength"].get<double>(), 2e-3, 1e-12);
    EXPECT_NEAR(n["modulus_Pa"].get<double>(), 50e9, 1e3);
    EXPECT_TRUE(n["failed"].get<bool>());
    EXPECT_EQ(n["in_tension"].get<bool>(), sign < 0);
    EXPECT_EQ(n["broken"]["tension"].get<double>(), 200);
    EXPECT_EQ(n["broken"]["all"].get<double>(), 203);
    EXPECT_EQ(n["broken_at_strength"]["all"].get<double>(), 3);
    EXPECT_FALSE(found.contains("peak"));
  }
}

TEST(TestNumbers, OfARockThatStillHoldsSayThatItHasNotFailed) {
  StageResult stage = rock();
  for (auto& c : stage.history.columns) c.values.resize(210);
  EXPECT_FALSE(test_numbers(fields::Test{stage})["uniaxial"]["failed"].get<bool>());
}

TEST(TestNumbers, AreReadAsTheyAreStored) {
  StageResult stage = rock();
  EXPECT_EQ(test_of(fields::Test{stage})["uniaxial"]["failed"].get<bool>(), true);
  stage.texture = {{"uniaxial", {{"strength_Pa", 3.0}}}, {"solid_fraction", 0.8}};
  EXPECT_EQ(test_of(fields::Test{stage}), Numbers({{"uniaxial", {{"strength_Pa", 3.0}}}}));
}

double growth_at(double strain) { return 0.05 * (1 - std::exp(-4 * strain)); }

/// Sheared along its top: friction rises to 0.5, falls to 0.3 within a third of the test, and scatters about that by
/// 0.02. Meanwhile it grows by 5 %.
StageResult dense(std::size_t rows = 3000) {
  StageResult stage = box(rows);
  for (const char* name : {"shear_strain", "bottom_shear_force", "top_shear_force"})
    stage.history.columns.push_back({name, "", std::vector<double>(rows, 0.0)});
  RandomStream random(5, Purpose::order);
  for (std::size_t k = 0; k < rows; ++k) {
    const double strain = 4 * static_cast<double>(k) / static_cast<double>(rows);
    const double mu = 0.3 * (1 - std::exp(-40 * strain)) + 0.3 * std::min(1.0, 10 * strain) * std::exp(-4 * strain) +
                      0.02 * random.normal();
    column(stage, "time")[k] = static_cast<double>(k);
    column(stage, "right_position")[k] = 0.1;
    column(stage, "top_position")[k] = 0.1 * (1 + growth_at(strain) + 1e-3 * random.normal());
    column(stage, "shear_strain")[k] = strain;
    column(stage, "bottom_force")[k] = column(stage, "top_force")[k] = 100;
    column(stage, "bottom_shear_force")[k] = 100 * mu;
    column(stage, "top_shear_force")[k] = -100 * mu;
  }
  return stage;
}

TEST(TestNumbers, OfADenseSampleHaveAPeakBeforeTheCriticalState) {
  const Numbers found = test_numbers(fields::Test{dense()});
  ASSERT_TRUE(found.contains("critical_state") && found.contains("peak"));
  EXPECT_LT(found["peak"]["strain"].get<double>(), found["critical_state"]["from"].get<double>());
  EXPECT_NEAR(found["peak"]["mu"].get<double>(), 0.3 + 0.3 * std::exp(-0.4), 0.03);
  // Of one row each, which scatters by 0.1 %: four times that.
  const double peak = found["peak"]["strain"].get<double>();
  EXPECT_NEAR(found["peak"]["volumetric_strain"].get<double>(), -growth_at(peak), 4e-3);
  EXPECT_NEAR(found["end"]["volumetric_strain"].get<double>(), -growth_at(4), 4e-3);
  EXPECT_LT(growth_at(peak), 0.5 * growth_at(4));
}

/// A box whose lid comes down: stress over strain is 20 MPa, across it 0.4 of that.
StageResult oedometer() {
  StageResult stage = box(101);
  for (std::size_t k = 0; k <= 100; ++k) {
    const double strain = 1e-4 * static_cast<double>(k), stress = 2e7 * strain;
    column(stage, "time")[k] = static_cast<double>(k);
    column(stage, "right_position")[k] = 0.1;
    column(stage, "top_position")[k] = 0.1 * (1 - strain);
    column(stage, "bottom_force")[k] = column(stage, "top_force")[k] = stress * 0.1 * 0.01;
    column(stage, "left_force")[k] = column(stage, "right_force")[k] = 0.4 * stress * 0.1 * (1 - strain) * 0.01;
  }
  stage.asked.in_motion = true;
  return stage;
}

TEST(TestNumbers, OfAnOedometerAreItsModulusAndTheLateralStress) {
  const StageResult stage = oedometer();
  EXPECT_EQ(kind_of(fields::Test{stage}), TestKind::oedometer);
  const Numbers n = test_numbers(fields::Test{stage})["oedometer"];
  EXPECT_NEAR(n["modulus_Pa"].get<double>(), 2e7, 1);
  EXPECT_NEAR(n["lateral_ratio"].get<double>(), 0.4, 1e-12);
  EXPECT_NEAR(n["stress_Pa"].get<double>(), 2e5, 1e-6);
  EXPECT_NEAR(n["strain"].get<double>(), 0.01, 1e-12);
}

TEST(TestNumbers, OfASampleThatAPressureClosesFromNothingAreNone) {
  StageResult stage = oedometer();
  stage.asked.in_motion = false;
  EXPECT_EQ(kind_of(fields::Test{stage}), TestKind::none);
}

TEST(TestNumbers, OfACompressionFromAllSidesAreNone) {
  StageResult stage = box(101);
  for (std::size_t k = 0; k <= 100; ++k) {
    const double size = 0.1 * (1 - 1e-4 * static_cast<double>(k));
    column(stage, "time")[k] = static_cast<double>(k);
    column(stage, "right_position")[k] = column(stage, "top_position")[k] = size;
    for (const char* side : {"left", "right", "bottom", "top"}) column(stage, std::string(side) + "_force")[k] = 10;
  }
  EXPECT_EQ(kind_of(fields::Test{stage}), TestKind::none);
  EXPECT_TRUE(test_numbers(fields::Test{stage}).empty());
}

TEST(TestKind, TellsASiloACollapseAndADrum) {
  StageResult stage = box(2);
  stage.texture = Numbers{{"surface", Numbers{{"runout_m", 0.1}}}};
  EXPECT_EQ(kind_of(fields::Test{stage}), TestKind::collapse);
  Boundary drum;
  drum.points = {{0, 0}, {1, 0}, {0, 1}};
  drum.closed = true;
  drum.spin = 1;
  stage.snapshots.back().packing.domain.boundaries.push_back(drum);
  EXPECT_EQ(kind_of(fields::Test{stage}), TestKind::drum);
  stage.texture["discharge"] = Numbers{{"steady", true}};
  EXPECT_EQ(kind_of(fields::Test{stage}), TestKind::discharge);
}

TEST(TestKind, TellsCyclesByTheirTable) {
  StageResult stage = rock();
  stage.cycles.columns = {{"cycle", "1", {1, 1, 2, 2}}};
  EXPECT_EQ(kind_of(fields::Test{stage}), TestKind::cycles);
}

}  // namespace
}  // namespace arenite::fields
