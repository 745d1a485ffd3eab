#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "grains/dem/run_stage.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

using testing::add_grain;
using testing::crowd;
using testing::empty_container;

ContactParameters springy(double restitution) {
  ContactParameters contact;
  contact.friction_law = dem::CundallStrack{};
  contact.restitution = restitution;
  return contact;
}

/// Runs a stage to its end.
StageResult run(Engine& engine, const Stage& stage) {
  StageRun run = begin_stage(engine, stage);
  while (!run.finished) continue_stage(engine, stage, run);
  return run.result;
}

Stage pressed_from_all_sides(double pressure) {
  Stage stage;
  stage.name = "press";
  for (auto& side : stage.side) side = {SideDrive::Kind::pressure, pressure};
  stage.equilibrium.max_steps = 400'000;
  return stage;
}

/// Disks of 8 and 32 mm side by side on a lattice with room between them.
Packing unlike_sizes(double sheared = 0.001) {
  Packing p = empty_container(0.21, 0.21);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 5; ++column) {
      const double x = 0.04 * column + 0.017 + sheared * row, y = 0.04 * row + 0.017 + 0.0007 * column;
      add_grain(p, x, y, 0.016);
      add_grain(p, x + 0.0195, y + 0.0195, 0.004);
    }
  return p;
}

TEST(EvenMasses, KeepTheRestitutionOfUnlikeDisks) {
  Packing p = empty_container(0.2, 0.2);
  add_grain(p, 0.08, 0.1, 0.016);
  add_grain(p, 0.10001, 0.1, 0.004);
  p.grains.velocity[0].x = 1.0;
  IntegrationParameters integration;
  integration.safety = 1.0 / 500;
  Engine engine(p, springy(0.5), integration);
  set_mass_scaling(engine, MassScaling::uniform);
  engine.advance(2000);
  const Packing after = packing_of(engine);
  EXPECT_NEAR(after.grains.velocity[1].x - after.grains.velocity[0].x, 0.5, 1e-3);
  EXPECT_NEAR(after.grains.velocity[1].x + after.grains.velocity[0].x, 1.0, 1e-9) << "equal masses share the momentum";
}

TEST(EvenMasses, AreThoseOfTheGrainWithTheFastestContacts) {
  Packing p = empty_container(1, 1);
  const auto light = add_grain(p, 0.2, 0.2, 0.004), heavy = add_grain(p, 0.8, 0.8, 0.016),
             soft = add_grain(p, 0.5, 0.5, 0.012, 1);
  for (const auto k : {light, heavy, soft}) p.grains.velocity[k].x = 1;
  Engine engine(p, springy(0.5), {});
  const double own = energies_of(engine).kinetic;
  set_mass_scaling(engine, MassScaling::uniform);
  const double lightest = 1410 * std::numbers::pi * 0.004 * 0.004 * 0.06;
  EXPECT_NEAR(energies_of(engine).kinetic, 0.5 * lightest * (2 + 6.43 / 27.35), 1e-12 * own);
  set_mass_scaling(engine, MassScaling::none);
  EXPECT_DOUBLE_EQ(energies_of(engine).kinetic, own);
}

TEST(EvenMasses, AreHeavyEnoughForTheStepThatTheOwnOnesAllow) {
  // A lattice with a slightly smaller grain, free in the place of one of its own: it alone sets the step of own masses,
  // and a whole lattice of its mass is faster.
  const double d = 0.01, pitch = d * (1 - 1e-4), rise = pitch * std::sqrt(0.75);
  Packing p = empty_container(12 * pitch, 12 * rise);
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  for (int r = 0; r < 12; ++r)
    for (int c = 0; c < 12; ++c)
      add_grain(p, (c + 0.25 + 0.5 * (r % 2)) * pitch, (r + 0.5) * rise, (r == 6 && c == 6 ? 0.45 : 0.5) * d);
  IntegrationParameters integration;
  integration.time_step = 1e-9;
  integration.time_step = 0.999 * step_bounds(Engine(p, springy(0.5), integration)).largest();
  Engine engine(p, springy(0.5), integration);
  set_mass_scaling(engine, MassScaling::uniform);
  EXPECT_GE(step_bounds(engine).largest(), *integration.time_step);
  EXPECT_LT(step_bounds(engine).largest(), 1.01 * *integration.time_step) << "no heavier than needed";
  set_mass_scaling(engine, MassScaling::none);
  EXPECT_NEAR(0.999 * step_bounds(engine).largest(), *integration.time_step, 1e-12);
}

/// A lattice of equal disks that do not touch yet, in a periodic cell: a step at its bound is too long once they do.
Packing lattice_about_to_touch() {
  const double d = 0.01, pitch = d * (1 + 1e-4), rise = pitch * std::sqrt(0.75);
  Packing p = empty_container(12 * pitch, 12 * rise);
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  for (int r = 0; r < 12; ++r)
    for (int c = 0; c < 12; ++c) add_grain(p, (c + 0.25 + 0.5 * (r % 2)) * pitch, (r + 0.5) * rise, 0.5 * d);
  return p;
}

WallDrives squeezed() {
  const auto at = [](double speed) { return WallDrive{WallDrive::Kind::velocity, speed}; };
  return {at(0.02), at(-0.02), at(0.02), at(-0.02)};
}

IntegrationParameters as_long_as_allowed(IntegratorKind integrator) {
  IntegrationParameters integration;
  integration.safety = 100;
  integration.integrator = integrator;
  integration.track_energy = true;
  return integration;
}

TEST(EvenMasses, AStepOfTheProgramsOwnIsShortenedWhereTheGrainsOwnMassesAreTooLight) {
  for (const auto integrator : {IntegratorKind::velocity_verlet, IntegratorKind::leapfrog, IntegratorKind::gear5}) {
    const auto how = as_long_as_allowed(integrator);
    Engine engine(lattice_about_to_touch(), springy(0.2), how), resumed(lattice_about_to_touch(), springy(0.2), how);
    set_mass_scaling(engine, MassScaling::uniform);
    set_drives(engine, squeezed());
    while (time_of(engine) < 1e-3) engine.advance(1);
    const double before = time_of(engine), step = engine.dt;
    ASSERT_GT(step, step_bounds(engine).largest()) << "the case that this is about";
    set_mass_scaling(engine, MassScaling::none);
    EXPECT_LT(engine.dt, step_bounds(engine).largest());
    EXPECT_EQ(time_of(engine), before);
    restore_sample(resumed, save_sample(engine));
    for (Engine* e : {&engine, &resumed}) {
      e->advance(100);
      EXPECT_NEAR(time_of(*e), before + 100 * e->dt, 1e-12 * before);
      EXPECT_LT(e->dt, step);
    }
    EXPECT_EQ(state_hash(engine), state_hash(resumed));
  }
}

TEST(EvenMasses, AStepThatWasGivenIsRefusedWithTheOneThatWouldDo) {
  auto how = as_long_as_allowed(IntegratorKind::velocity_verlet);
  how.time_step = Engine(lattice_about_to_touch(), springy(0.2), how).dt;
  Engine engine(lattice_about_to_touch(), springy(0.2), how);
  set_mass_scaling(engine, MassScaling::uniform);
  set_drives(engine, squeezed());
  while (time_of(engine) < 1e-3) engine.advance(1);
  try {
    set_mass_scaling(engine, MassScaling::none);
    FAIL() << "refused";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("integration.time_step"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("; use "), std::string::npos) << e.what();
  }
}

/// Until unlike disks, placed a little differently each time, are at rest under pressure.
std::int64_t steps_of_ten_compactions(MassScaling masses) {
  std::int64_t steps = 0;
  for (const double sheared : {0.0006, 0.0007, 0.0008, 0.0009, 0.001, 0.0011, 0.0012, 0.0013, 0.0014, 0.0015}) {
    Engine engine(unlike_sizes(sheared), springy(0.5), {});
    Stage stage = pressed_from_all_sides(1e-3 * 27.35e6 / 0.06);
    stage.mass_scaling = masses;
    stage.inertial_number = 1;
    const StageResult result = run(engine, stage);
    EXPECT_TRUE(result.converged) << result.outcome;
    steps += engine.step;
  }
  return steps;
}

TEST(EvenMasses, CompactUnlikeDisksInFarFewerSteps) {
  // How many steps one sample takes hangs on the last slip before it rests: the ratio is 1.5 to 3.5, of ten 2.0 +-
  // 0.15.
  EXPECT_LT(3 * steps_of_ten_compactions(MassScaling::uniform), 2 * steps_of_ten_compactions(MassScaling::none));
}

TEST(EvenMasses, AreRefusedWhereGrainsWeigh) {
  Engine engine(unlike_sizes(), springy(0.5), {});
  Stage stage = pressed_from_all_sides(1e5);
  stage.mass_scaling = MassScaling::uniform;
  stage.gravity = true;
  EXPECT_THROW(begin_stage(engine, stage), InputError);
}

TEST(EvenMasses, GoOnWithTheSameBitsAfterARestore) {
  Engine whole(crowd(12, 12, 5), springy(0.5), {}), resumed(crowd(12, 12, 5), springy(0.5), {});
  Stage stage = pressed_from_all_sides(1e5);
  stage.mass_scaling = MassScaling::uniform;
  stage.inertial_number = 0.5;
  begin_stage(whole, stage);
  set_drives(whole, {{{WallDrive::Kind::force, 2000}, {}, {WallDrive::Kind::force, 2000}, {}}});
  whole.advance(300);
  restore_sample(resumed, save_sample(whole));
  whole.advance(300);
  resumed.advance(300);
  EXPECT_EQ(state_hash(whole), state_hash(resumed));
}

TEST(InertialNumber, LetsOverlappingGrainsPushTheirSidesAwayFaster) {
  double grown[2];
  for (const double number : {0.01, 1.0}) {
    Engine engine(crowd(14, 14, 3, 0.0145), springy(0.5), {});
    Stage stage = pressed_from_all_sides(1e-4 * 6.43e6 / 0.06);
    stage.inertial_number = number;
    const double area = engine.domain.area();
    StageRun under_way = begin_stage(engine, stage);
    for (int look = 0; look < 15; ++look) continue_stage(engine, stage, under_way);
    grown[number > 0.5] = engine.domain.area() - area;
  }
  EXPECT_GT(grown[0], 0);
  EXPECT_GT(grown[1], 2 * grown[0]);
}

/// Drag of the stage, of the integration and of the slowest wave add up.
TEST(CriticalDrag, IsPiOverThePassageOfAWave) {
  Packing p = empty_container(2, 1);
  add_grain(p, 0.5, 0.5, 0.005);
  add_grain(p, 1.5, 0.5, 0.005);
  p.grains.velocity[0].x = 1;
  IntegrationParameters integration;
  integration.drag = 30;
  Engine engine(p, springy(0.5), integration);
  const double passage = std::sqrt(2 * 1410 * std::numbers::pi * 25e-6 * 0.06 / (27.35e6 / 2));  // along the wide side
  EXPECT_NEAR(critical_drag(engine), std::numbers::pi / passage, 1e-9 / passage);
  Stage stage;
  stage.name = "slow down";
  stage.drag = 20;
  stage.critical_drag = 0.01;
  stage.duration = 0.01;
  run(engine, stage);
  const double rate = 50 + 0.01 * std::numbers::pi / passage;
  EXPECT_NEAR(packing_of(engine).grains.velocity[0].x, std::exp(-rate * time_of(engine)), 1e-6);
}

}  // namespace
}  // namespace arenite::dem
