#include <gtest/gtest.h>

#include <cmath>

#include "grains/dem/measure.hpp"
#include "grains/dem/run_stage.hpp"
#include "unit/grains/dem/boundaries/boxes.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

using testing::add_grain;
using testing::empty_container;
using testing::to_its_end;

constexpr double radius = 3e-3, wide = 50e-3;

/// A wide disk that the upper wall presses on the lower one, and a small disk beside it that nothing holds.
Packing pressed_and_loose() {
  Packing p = empty_container(3 * wide, 2 * wide);
  add_grain(p, wide, wide, wide);
  add_grain(p, 2.6 * wide, wide, radius);
  return p;
}

ContactParameters contact(double restitution = 0.3) {
  ContactParameters law;
  law.friction_law = dem::CundallStrack{};
  law.friction = 0.3;
  law.restitution = restitution;
  return law;
}

Stage pressed(bool gravity) {
  Stage stage;
  stage.name = "load";
  stage.gravity = gravity;
  stage.side[top] = {SideDrive::Kind::force, 20e3};
  return stage;
}

TEST(Rest, IsNotReachedWhileADiskFallsHoweverSmallItsWeight) {
  const Packing start = pressed_and_loose();
  Stage stage = pressed(true);
  Engine engine(start, contact(), {});
  const StageRun run = to_its_end(engine, stage);
  ASSERT_TRUE(run.result.converged) << run.result.outcome;
  const Snapshot& end = run.result.snapshots.back();
  EXPECT_EQ(end.equilibrium.falling, 0);
  EXPECT_NEAR(end.packing.grains.position.back().y, radius, 0.01 * radius);

  // Where the forces of the pressed disk alone are asked, the other is still on its way.
  stage.equilibrium.falling = 1;
  stage.equilibrium.loose_kinetic = 1e9;
  Engine again(start, contact(), {});
  const StageRun early = to_its_end(again, stage);
  EXPECT_EQ(early.result.snapshots.back().equilibrium.falling, 0.5);
  EXPECT_LT(again.step, engine.step);
}

TEST(Rest, IsNotReachedWhileALooseDiskFliesFast) {
  Packing start = pressed_and_loose();
  start.grains.velocity.back().x = 100;
  Engine engine(start, contact(0.9), {});
  Stage stage = pressed(false);
  const StageRun run = to_its_end(engine, stage);
  EXPECT_LT(run.result.snapshots.back().equilibrium.loose_kinetic, 0.1);
  Packing slow = pressed_and_loose();
  slow.grains.velocity.back().x = 1e-3;
  Engine calm(slow, contact(0.9), {});
  to_its_end(calm, stage);
  EXPECT_LT(calm.step, engine.step);
}

TEST(Rest, IsReachedWhileADiskThatTouchesNothingSpins) {
  Packing start = pressed_and_loose();
  start.grains.omega.back() = 1e4;
  Engine engine(start, contact(0.9), {});
  const StageRun run = to_its_end(engine, pressed(false));
  ASSERT_TRUE(run.result.converged) << run.result.outcome;
  EXPECT_EQ(run.result.snapshots.back().packing.grains.omega.back(), 1e4);
}

TEST(Rest, ADiskThatNothingPressesToSpeakOfIsLooseAndMaySpin) {
  const auto bearing = [](double overlap) {
    Packing start = empty_container(3 * wide, 2 * wide);
    add_grain(start, 1.5 * wide, wide, wide + 1e-6);
    add_grain(start, 3 * wide - radius + overlap, radius - overlap, radius);  // in a corner
    start.grains.omega.back() = 1e4;
    return equilibrium_of(Engine(start, contact(), {})).kinetic_ratio;
  };
  EXPECT_GT(bearing(1e-8), 0);
  EXPECT_EQ(bearing(1e-13), 0);
}

/// A sphere in a corner, pressed by another one towards it, that spins about an axis: what its motion is to the elastic
/// energy.
double motion_in_a_corner(Vec3 axis, const ContactParameters& contact) {
  const double pressed = 1e-6;
  PackingIn<3> start = testing::box_with({}, 0.1);
  start.domain.boundaries.clear();
  const Vec3 corner{testing::ball - pressed, testing::ball - pressed, testing::ball - pressed};
  testing::add_ball(start, corner);
  testing::add_ball(start, corner + (2 * testing::ball - pressed) / std::sqrt(3) * Vec3{1, 1, 1});
  start.grains.omega.front() = 100 * axis;
  return equilibrium_of(EngineIn<3>(start, contact, {})).kinetic_ratio;
}

TEST(Rest, IsOfWhatContactsResist) {
  ContactParameters contact = testing::rubbing(0.3);
  const Vec3 about{1, 1, 1}, across{1, -1, 0};
  EXPECT_GT(motion_in_a_corner(about, contact), 0.1) << "the walls rub";
  contact.wall_friction = 0;
  EXPECT_LT(motion_in_a_corner(about, contact), 1e-9) << "a twist about the only normal that rubs";
  EXPECT_GT(motion_in_a_corner(across, contact), 0.1);
  contact.rolling = ElasticPlasticRolling{0.1, 0.3};
  EXPECT_GT(motion_in_a_corner(about, contact), 0.1) << "walls resist rolling";
  contact.friction = 0;
  contact.rolling = {};
  EXPECT_EQ(motion_in_a_corner(across, contact), 0) << "nothing rubs";
}

/// A sphere between two others, almost on one line, that spins about an axis: what its motion is to the elastic energy.
double motion_between_two(Vec3 axis, Vec3 first, Vec3 second) {
  PackingIn<3> start = testing::box_with({}, 0.1);
  start.domain.boundaries.clear();
  const Vec3 middle{0.05, 0.05, 0.05};
  const double reach = 2 * testing::ball - 1e-6;
  testing::add_ball(start, middle);
  testing::add_ball(start, middle + reach * first);
  testing::add_ball(start, middle + reach * second);
  start.grains.omega.front() = 100 * axis;
  return equilibrium_of(EngineIn<3>(start, testing::rubbing(0.3), {})).kinetic_ratio;
}

TEST(Rest, ASphereBetweenTwoPointsSpinsAboutTheirLineWithoutResistance) {
  const Vec3 first{0, 0.6, 0.8}, second{0.06, -0.64, -0.766};
  const Vec3 to_second = 1 / norm(second) * second, line = 1 / norm(first - to_second) * (first - to_second);
  EXPECT_LT(motion_between_two(line, first, to_second), 1e-9);
  EXPECT_GT(motion_between_two({1, 0, 0}, first, to_second), 0.1);
  EXPECT_GT(motion_between_two(first, first, to_second), 1e-5) << "about one contact the other resists";
}

TEST(Rest, ManyDisksThatAllFallAreNotAtRest) {
  Packing start = empty_container(0.2, 1);
  for (int k = 0; k < 10; ++k) add_grain(start, 0.02 * k + 0.01, 0.9, radius);
  Engine engine(start, contact(), {});
  set_gravity(engine, {0, -standard_gravity});
  engine.advance(100);
  const Equilibrium now = equilibrium_of(engine);
  EXPECT_EQ(now.falling, 1);
  EXPECT_TRUE(std::isinf(now.loose_kinetic));
}

}  // namespace
}  // namespace arenite::dem
