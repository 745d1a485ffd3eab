#include <gtest/gtest.h>

#include <cmath>

#include "dem/run_stage.hpp"
#include "unit/dem/samples.hpp"

namespace arenite::dem {
namespace {

using testing::add_grain;
using testing::empty_frame;

constexpr double radius = 5e-3;

/// A block of disks, row on row, pressed between the lower and the upper wall, with a hole in its middle; a small disk hangs in
/// the hole just below the row above it.
Packing block_with_a_loose_disk() {
  const int columns = 7, rows = 7;
  Packing p = empty_frame(2 * radius * columns, 2 * radius * rows);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      if (!(row == 3 && column == 3)) add_grain(p, radius * (2 * column + 1), radius * (2 * row + 1), radius);
  add_grain(p, radius * 7, radius * 7 + 0.4 * radius, 0.3 * radius);
  return p;
}

ContactParameters contact() {
  ContactParameters law;
  law.friction_law = FrictionLaw::cundall_strack;
  law.friction = 0.3;
  law.restitution = 0.3;
  return law;
}

Stage pressed(bool gravity) {
  Stage stage;
  stage.name = "load";
  stage.gravity = gravity;
  stage.side[top] = {SideDrive::Kind::force, 20e3};
  stage.critical_drag = 0.1;
  return stage;
}

StageRun to_its_end(Engine& engine, const Stage& stage) {
  StageRun run = begin_stage(engine, stage);
  while (!run.finished) continue_stage(engine, stage, run);
  return run;
}

TEST(Rest, IsNotReachedWhileADiskFallsHoweverSmallItsWeight) {
  const Packing start = block_with_a_loose_disk();
  Stage stage = pressed(true);
  Engine engine(start, contact(), {});
  const StageRun run = to_its_end(engine, stage);
  ASSERT_TRUE(run.result.converged) << run.result.outcome;
  const Frame& end = run.result.frames.back();
  EXPECT_EQ(end.equilibrium.falling, 0);
  EXPECT_LT(end.packing.grains.y.back(), start.grains.y.back() - 0.5 * radius);

  // As long as the forces of the block alone were asked, the disk was still on its way.
  stage.rest.falling = 1;
  stage.rest.loose_kinetic = 1e9;
  Engine again(start, contact(), {});
  const StageRun early = to_its_end(again, stage);
  EXPECT_EQ(early.result.frames.back().equilibrium.falling, 1.0 / static_cast<double>(start.grains.size()));
  EXPECT_LT(again.step(), engine.step());
}

TEST(Rest, IsNotReachedWhileALooseDiskFliesFast) {
  Packing start = block_with_a_loose_disk();
  start.grains.vx.back() = 20;
  Engine engine(start, contact(), {});
  Stage stage = pressed(false);
  stage.critical_drag = 0;
  const StageRun run = to_its_end(engine, stage);
  EXPECT_LT(run.result.frames.back().equilibrium.loose_kinetic, 0.01);
  Packing slow = block_with_a_loose_disk();
  slow.grains.vx.back() = 1e-3;
  Engine calm(slow, contact(), {});
  to_its_end(calm, stage);
  EXPECT_LT(calm.step(), engine.step());
}

TEST(Rest, ManyDisksThatAllFallAreNotAtRest) {
  Packing start = empty_frame(0.2, 1);
  for (int k = 0; k < 10; ++k) add_grain(start, 0.02 * k + 0.01, 0.9, radius);
  Engine engine(start, contact(), {});
  engine.set_gravity({0, -standard_gravity});
  engine.advance(100);
  const Equilibrium now = engine.equilibrium();
  EXPECT_EQ(now.falling, 1);
  EXPECT_TRUE(std::isinf(now.loose_kinetic));
}

}  // namespace
}  // namespace arenite::dem
