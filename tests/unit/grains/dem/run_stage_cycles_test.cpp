#include <gtest/gtest.h>

#include <cmath>

#include "grains/dem/run_stage.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

using testing::add_grain;
using testing::crowd;
using testing::empty_container;
using testing::to_its_end;

const std::vector<double>& column(const History& history, const char* name) {
  for (const auto& c : history.columns)
    if (c.name == name) return c.values;
  throw std::out_of_range(name);
}

/// One disk that fills the snapshot from bottom to top.
Packing one_disk() {
  Packing p = empty_container(0.1, 0.02);
  add_grain(p, 0.05, 0.01, 0.01);
  return p;
}

TEST(StrainCycles, GoToAndFroBetweenTwoStrainsAndBackToTheForce) {
  const Packing start = one_disk();
  Engine engine(start, {}, {});
  Stage stage;
  stage.name = "cycle";
  stage.strain_cycles = StrainCycles{top, 0.0002, 0.001, 0.5, 400, 100};
  const StageRun run = to_its_end(engine, stage);
  const auto &at_maximum = column(run.result.cycles, "at_maximum"),
             &position = column(run.result.cycles, "top_position");
  const auto &force = column(run.result.cycles, "top_force"), &cycle = column(run.result.cycles, "cycle");
  ASSERT_EQ(cycle.size(), 800u);
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    const double strain = at_maximum[k] == 1 ? 0.001 : 0.0002;
    ASSERT_EQ(cycle[k], 1 + static_cast<double>(k / 2));
    ASSERT_EQ(at_maximum[k], k % 2 == 0 ? 1 : 0);
    ASSERT_NEAR(1 - position[k] / 0.02, strain, 1e-12);
    // Two springs in a row, k each, pressed by strain x 20 mm; what the dashpots and the disk's inertia add at 10 mm/s.
    ASSERT_NEAR(force[k], 0.5 * 27.35e6 * strain * 0.02, 0.03 * 0.5 * 27.35e6 * 0.001 * 0.02);
  }
  // States of the first cycle and of every hundredth.
  ASSERT_EQ(run.result.snapshots.size(), 10u);
  EXPECT_EQ(run.result.snapshots[1].label, "cycle 1 minimum");
  EXPECT_EQ(run.result.snapshots[2].label, "cycle 100 maximum");
  EXPECT_EQ(share_done(stage, run), 1);
}

TEST(StrainCycles, ShearACellToAndFro) {
  Packing start = crowd(8, 8, 3, 0.0125);
  start.domain.periodic[0] = start.domain.periodic[1] = true;
  for (Wall& wall : start.domain.wall) wall.present = false;
  Engine engine(start, {}, {});
  Stage stage;
  stage.name = "cycle";
  stage.strain_cycles = StrainCycles{StrainCycles::shear, -0.01, 0.01, 10, 3, {}};
  const StageRun run = to_its_end(engine, stage);
  const auto& strain = column(run.result.cycles, "shear_strain");
  ASSERT_EQ(strain.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(strain[k], k % 2 == 0 ? 0.01 : -0.01, 1e-12);
  EXPECT_EQ(run.result.snapshots.size(), 6u);
}

TEST(StrainCycles, ResumeToTheSameBits) {
  const Packing start = crowd(8, 8, 3, 0.0125);
  Stage stage;
  stage.name = "cycle";
  stage.strain_cycles = StrainCycles{right, 0, 0.002, 2, 5, {}};
  stage.side[top] = {SideDrive::Kind::pressure, 1e5};
  Engine whole(start, {}, {}), cut(start, {}, {}), again(start, {}, {});
  to_its_end(whole, stage);
  StageRun first = begin_stage(cut, stage);
  for (int k = 0; k < 11; ++k) continue_stage(cut, stage, first);
  ASSERT_FALSE(first.finished);
  StageRun second = begin_stage(again, stage);
  restore_sample(again, save_sample(cut));
  second.increment = first.increment;
  second.steps_in_increment = first.steps_in_increment;
  while (!second.finished) continue_stage(again, stage, second);
  EXPECT_EQ(state_hash(again), state_hash(whole));
}

TEST(StressCycles, KnowEveryCycleOfThousandsWithoutItsStates) {
  Engine engine(one_disk(), {}, {});
  Stage stage;
  stage.name = "cycle";
  stage.side[top] = {SideDrive::Kind::force, 100};
  stage.cycles = Cycles{top, 100, 1000, 1000, 1, 500};
  stage.equilibrium = {0.004, 0.01, 1, 1e9, {}, 100000};
  const StageRun run = to_its_end(engine, stage);
  ASSERT_TRUE(run.result.converged) << run.result.outcome;
  const auto &force = column(run.result.cycles, "top_force"), &at_maximum = column(run.result.cycles, "at_maximum");
  ASSERT_EQ(force.size(), 2000u);
  for (std::size_t k = 0; k < force.size(); ++k)
    ASSERT_NEAR(force[k] / (at_maximum[k] == 1 ? 1000 : 100), 1, 0.05) << k;
  ASSERT_EQ(run.result.snapshots.size(), 1u + 2 + 2 + 2);
  EXPECT_EQ(run.result.snapshots.back().label, "cycle 1000 minimum");
}

}  // namespace
}  // namespace arenite::dem
