#include <gtest/gtest.h>

#include <algorithm>

#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;

/// 6 x 6 equal disks that just touch each other and the walls: one stiff elastic body.
Packing crystal() {
  const double d = 12.4e-3;
  Packing p = box(6.5 * d, d * (1 + 5 * std::sqrt(0.75)));
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) add(p, {{d * (0.5 + c + 0.5 * (r % 2)), d * (0.5 + r * std::sqrt(0.75))}, d / 2});
  return p;
}
double crystal_step() {
  const Packing p = crystal();
  return contact_time(0.5 * mass(p, 0), k_pom) / 20;
}

dem::WallDrives bottom_pressed(double force) {
  return {dem::WallDrive{}, dem::WallDrive{}, pressed(force), dem::WallDrive{}};
}

TEST(Servo, AStepOfForceIsReachedWithoutMoreThanAFifthOfOvershootOnEitherWall) {
  Engine engine(crystal(), frictionless(0.1), with_step(crystal_step()));
  set_drives(engine, bottom_pressed(1000));
  ASSERT_TRUE(settle(engine));
  set_drives(engine, bottom_pressed(10000));
  double highest = 0;
  for (int part = 0; part < 4000; ++part) {
    engine.advance(10);
    highest = std::max({highest, engine.domain.wall[bottom].force, engine.domain.wall[top].force});
  }
  EXPECT_LT(highest, 1000 + 1.2 * 9000);
  EXPECT_NEAR(engine.domain.wall[bottom].force, 10000, 1);
  EXPECT_NEAR(engine.domain.wall[top].force, 10000, 1);
}

TEST(Servo, ClosesASmallGapAndIsStableOnOneDisk) {
  Packing p = box(0.2, 12.4e-3 + 1e-4);
  add(p, {{0.1, 0.0062}, 6.2e-3});
  Engine engine(p, frictionless(0.1), with_step(contact_time(mass(p, 0), k_pom) / 20));
  set_drives(engine, {dem::WallDrive{}, dem::WallDrive{}, dem::WallDrive{}, pressed(300)});
  engine.advance(400000);
  EXPECT_NEAR(engine.domain.wall[top].force, 300, 0.3);
  const double closed = 2 * 6.2e-3 - 2 * 300 / k_pom;
  EXPECT_NEAR(engine.domain.wall[top].position - engine.domain.wall[bottom].position, closed, 1e-4 * 300 / k_pom);
}

TEST(Servo, StandsStillWhereItsForceIsMet) {
  Engine engine(crystal(), frictionless(0.1), with_step(crystal_step()));
  set_drives(engine, bottom_pressed(5000));
  ASSERT_TRUE(settle(engine));
  const double before = engine.domain.wall[bottom].position;
  engine.advance(20000);
  EXPECT_NEAR(engine.domain.wall[bottom].position, before, 1e-6 * before);
}

TEST(Servo, CyclesFrom6To60KiloNewtonComeBackToTheSameStateInAnElasticFrictionlessSample) {
  Engine engine(crystal(), frictionless(0.1), with_step(crystal_step()));
  const auto ramp = [&](double from, double to) {
    for (int part = 1; part <= 5; ++part) {
      set_drives(engine, bottom_pressed(from + (to - from) * part / 5));
      ASSERT_TRUE(settle(engine, 1e-8, 1e-16)) << "at " << from + (to - from) * part / 5 << " N";
    }
  };
  ramp(0, 6000);
  const Packing first = packing_of(engine);
  double travelled = 0;
  for (int cycle = 0; cycle < 2; ++cycle) {
    ramp(6000, 60000);
    travelled = engine.domain.wall[bottom].position - first.domain.wall[bottom].position;
    ramp(60000, 6000);
  }
  const Packing last = packing_of(engine);
  EXPECT_GT(travelled, 1e-3);
  EXPECT_NEAR(last.domain.wall[bottom].position, first.domain.wall[bottom].position, 1e-6 * travelled);
  for (std::size_t i = 0; i < last.grains.size(); ++i)
    EXPECT_LT(norm(last.grains.position[i] - first.grains.position[i]), 1e-6 * travelled);
}

TEST(Servo, HoldsItsForceWhileTheOppositeWallPushesTheSampleAlong) {
  Engine engine(crystal(), frictionless(0.1), with_step(crystal_step()));
  set_drives(engine, bottom_pressed(5000));
  ASSERT_TRUE(settle(engine));
  set_drives(engine, {dem::WallDrive{}, dem::WallDrive{}, pressed(5000), moved(-0.2)});
  engine.advance(40000);
  EXPECT_NEAR(engine.domain.wall[bottom].force, 5000, 5);
  EXPECT_NEAR(engine.domain.wall[bottom].velocity, -0.2, 2e-4);
}

/// What brakes a wall must not hang on the force of now: it would then be braked more on its way out than in.
TEST(Servo, ItsForceIsTheOneAskedForOnAverageWhileTheOppositeWallGoesToAndFro) {
  Engine engine(crystal(), frictionless(0.1), with_step(crystal_step()));
  set_drives(engine, bottom_pressed(5000));
  ASSERT_TRUE(settle(engine));
  double sum = 0;
  std::int64_t looks = 0;
  for (int half = 0; half < 60; ++half) {
    set_drives(engine, {dem::WallDrive{}, dem::WallDrive{}, pressed(5000), moved(half % 2 == 0 ? -0.5 : 0.5)});
    for (int look = 0; look < 100; ++look) {
      engine.advance(10);
      if (half < 10) continue;
      sum += engine.domain.wall[bottom].force;
      ++looks;
    }
  }
  EXPECT_NEAR(sum / static_cast<double>(looks), 5000, 25);
}

/// The walls of a driven sample are light; at rest again they are those of before.
TEST(Servo, GoesOnWithTheSameBitsHoweverTheStepsAreCountedAndAfterARestore) {
  const auto begun = [] {
    Engine engine(crystal(), frictionless(0.1), with_step(crystal_step()));
    set_drives(engine, bottom_pressed(5000));
    engine.advance(2000);
    set_drives(engine, {dem::WallDrive{}, dem::WallDrive{}, pressed(5000), moved(-0.2)});
    return engine;
  };
  Engine whole = begun(), parts = begun(), restored = begun();
  whole.advance(500);
  for (int part = 0; part < 50; ++part) parts.advance(10);
  restore_sample(restored, save_sample(parts));
  EXPECT_EQ(state_hash(whole), state_hash(parts));
  for (Engine* engine : {&whole, &parts, &restored}) {
    set_drives(*engine, bottom_pressed(5000));
    engine->advance(500);
  }
  EXPECT_EQ(state_hash(whole), state_hash(parts));
  EXPECT_EQ(state_hash(whole), state_hash(restored));
}

/// The longest step that the bounds allow is long enough for the lightest walls.
TEST(Servo, IsStableAtTheLongestStepOnWallsOfADrivenSample) {
  const double longest = step_bounds(Engine(crystal(), frictionless(0.1), with_step(crystal_step()))).largest();
  Engine engine(crystal(), frictionless(0.1), with_step(0.99 * longest));
  set_drives(engine, {dem::WallDrive{}, dem::WallDrive{}, pressed(5000), moved(-0.05)});
  engine.advance(40000);
  EXPECT_NEAR(engine.domain.wall[bottom].force, 5000, 50);
}

TEST(Servo, AWallDrivenByVelocityMovesByItExactly) {
  Engine engine(crystal(), frictionless(0.1), with_step(crystal_step()));
  set_drives(engine, {moved(-0.2), moved(0.3), moved(-0.4), moved(0.5)});
  engine.advance(1000);
  const double t = time_of(engine);
  const Packing start = crystal();
  const double speeds[] = {-0.2, 0.3, -0.4, 0.5};
  for (int side = 0; side < 4; ++side)
    EXPECT_NEAR(engine.domain.wall[side].position - start.domain.wall[side].position, speeds[side] * t, 1e-12);
}

}  // namespace
}  // namespace arenite::verification
