#include "grains/dem/programme.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/dem/run_stage.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

using testing::add_grain;
using testing::crowd;
using testing::empty_container;

using What = Programme::What;
constexpr Driven velocity_of(int side) { return {What::velocity, side}; }
constexpr Driven force_on(int side) { return {What::force, side}; }
constexpr Driven pressure_on(int side) { return {What::pressure, side}; }

Stage stage_with(std::vector<Programme> programmes, double duration) {
  Stage stage;
  stage.name = "load";
  stage.duration = duration;
  stage.programmes = std::move(programmes);
  for (const Programme& p : stage.programmes)
    if (p.of.is_of_side()) stage.side[static_cast<std::size_t>(p.of.side)] = {p.of.kind(), p.table.front().y};
  return stage;
}

TEST(Programme, IsLinearBetweenItsRowsJumpsWhereTwoHaveOneTimeAndBeginsAnew) {
  Programme p{{}, {{1, 10}, {2, 20}, {2, 5}, {4, 7}}, false};
  EXPECT_EQ(p.at(-1), 10);
  EXPECT_EQ(p.at(0.5), 10);
  EXPECT_EQ(p.at(1.25), 12.5);
  EXPECT_EQ(p.at(2), 5);
  EXPECT_EQ(p.at(3), 6);
  EXPECT_EQ(p.at(9), 7);
  p.repeat = true;
  EXPECT_EQ(p.at(4.5), 10);
  EXPECT_EQ(p.at(9.25), 12.5);
  EXPECT_EQ(p.at(8003), 6);
}

TEST(Programme, HasTheAreaBelowItsTable) {
  Programme p{{}, {{1, 10}, {2, 20}, {2, 5}, {4, 7}}, false};
  EXPECT_EQ(integral(p, 0), 0);
  EXPECT_DOUBLE_EQ(integral(p, 1.5), 10 + 0.5 * 12.5);
  EXPECT_DOUBLE_EQ(integral(p, 2), 10 + 15);
  EXPECT_DOUBLE_EQ(integral(p, 5), 10 + 15 + 12 + 7);
  p.repeat = true;
  EXPECT_DOUBLE_EQ(integral(p, 8 + 1.5), 2 * 37 + 10 + 0.5 * 12.5);
  for (const double t : {0.3, 1.7, 3.1, 4.5, 6.2, 9.25})
    EXPECT_NEAR((integral(p, t + 1e-6) - integral(p, t - 1e-6)) / 2e-6, p.at(t), 1e-5) << t;
}

TEST(Programme, MovesAWallByTheAreaBelowItsVelocities) {
  Packing start = empty_container(0.2, 0.2);
  add_grain(start, 0.1, 0.1, 0.005);
  for (const IntegratorKind kind : {IntegratorKind::velocity_verlet, IntegratorKind::gear5}) {
    IntegrationParameters integration;
    integration.integrator = kind;
    Engine engine(start, {}, integration);
    const Stage stage = stage_with(
        {{velocity_of(top), {{0, 0}, {0.002, 2}, {0.004, -1}}}, {velocity_of(left), {{0, 1}, {0.001, 1}, {0.001, 0}}}},
        0.004);
    StageRun run = begin_stage(engine, stage);
    while (!run.finished) continue_stage(engine, stage, run);
    // Triangles of 0.002 s x 2 m/s / 2 and the way down to -1 m/s; where a table bends within a step, the square of
    // that is lost at most.
    const double bend = 2000 * engine.dt * engine.dt, late = time_of(engine) - 0.004;
    EXPECT_NEAR(0.2 - engine.domain.wall[top].position, 0.002 + 0.001 - late, bend);
    EXPECT_NEAR(engine.domain.wall[left].position, 0.001, engine.dt);  // it stops within a step
    EXPECT_NEAR(engine.domain.wall[top].velocity, 1, 2000 * engine.dt);
  }
}

TEST(Programme, TurnsAndScalesTheWeightOfAFreeGrain) {
  Packing start = empty_container(10, 10);
  add_grain(start, 5, 5, 0.005);
  IntegrationParameters integration;
  integration.track_energy = true;
  Engine engine(start, {}, integration);
  Stage stage = stage_with({{{What::gravity_size}, {{0, 0}, {0.1, 10}}}}, 0.1);
  stage.gravity = true;
  stage.gravity_size = 0;
  stage.gravity_angle = std::numbers::pi / 2;  // along +x
  StageRun run = begin_stage(engine, stage);
  while (!run.finished) continue_stage(engine, stage, run);
  const Packing end = packing_of(engine);
  const double dt = engine.dt;                          // what the last step lies beyond the end of the table
  EXPECT_NEAR(end.grains.velocity[0].x, 0.5, 10 * dt);  // 100 m/s^3 t^2/2
  EXPECT_NEAR(end.grains.position[0].x - 5, 100 * 1e-3 / 6, dt);
  EXPECT_NEAR(end.grains.velocity[0].y, 0, 1e-12);
  const Energies e = energies_of(engine);
  EXPECT_NEAR(e.work_gravity, e.kinetic, 1e-6 * e.kinetic);
}

/// Disks of one size on a triangular lattice in a periodic cell, touching.
Packing crystal() {
  const double d = 0.012, columns = 6, rows = 6;
  Packing p = empty_container(columns * d, rows * d * std::sqrt(0.75));
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  for (Wall& wall : p.domain.wall) wall.present = false;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      add_grain(p, d * (0.25 + c + 0.5 * (r % 2)), d * std::sqrt(0.75) * (r + 0.5), d / 2);
  return p;
}

TEST(Programme, HoldsACrystalOnAPathOfStressAtAGivenRatio) {
  const Packing start = crystal();
  ContactParameters law;
  law.friction_law = NoFriction{};
  Engine engine(start, law, {});
  const double c11 = std::sqrt(3) / 4 * 3 * 27.35e6 / 0.06, c12 = c11 / 3, peak = 2e6,
               time = 0.05;  // Pa, of springs 60 mm long
  Stage stage = stage_with(
      {{pressure_on(top), {{0, 0}, {time, peak}}}, {pressure_on(right), {{0, 0}, {time, 0.6 * peak}}}}, time);
  stage.drag = 3000;
  StageRun run = begin_stage(engine, stage);
  double share = 0.25;
  while (!run.finished) {
    continue_stage(engine, stage, run);
    if (time_of(engine) < share * time) continue;
    share += 0.25;
    const Domain& d = engine.domain;
    const double yy = time_of(engine) / time * peak, xx = 0.6 * yy;
    EXPECT_NEAR(d.wall[top].force / (d.width() * d.thickness), yy, 0.005 * peak);
    EXPECT_NEAR(d.wall[right].force / (d.height() * d.thickness), xx, 0.005 * peak);
    // Hooke's law of the lattice, up to strains of their own order (0.4 %), and what the sides lag behind.
    const double det = c11 * c11 - c12 * c12;
    EXPECT_NEAR(1 - d.height() / start.domain.height(), (c11 * yy - c12 * xx) / det, 0.01 * peak * c11 / det);
    EXPECT_NEAR(1 - d.width() / start.domain.width(), (c11 * xx - c12 * yy) / det, 0.01 * peak * c11 / det);
  }
  EXPECT_GT(share, 1);
}

TEST(Programme, DoesTheWorkThatTheSampleTakes) {
  Packing start = crystal();
  for (Wall& wall : start.domain.wall) wall.present = true;
  start.domain.periodic[0] = start.domain.periodic[1] = false;
  for (int side = 0; side < 4; ++side) {  // rows that stand off stay inside, all but touching
    const Vec2 inward = inward_normal(side);
    start.domain.wall[static_cast<std::size_t>(side)].position -=
        (inward.x + inward.y) * (side < bottom ? 0.003 : 0.0009);
  }
  ContactParameters law;
  law.friction = 0.4;
  IntegrationParameters integration;
  integration.track_energy = true;
  integration.safety = 0.005;
  Engine engine(start, law, integration);
  Stage stage = stage_with({{force_on(top), {{0, 0}, {0.002, 4e3}, {0.003, 1e3}}},
                            {{What::slide, top}, {{0, 0}, {0.003, 0.2}}},
                            {{What::gravity_angle}, {{0, 0}, {0.003, 1}}}},
                           0.003);
  stage.gravity = true;
  stage.gravity_size = 500;
  StageRun run = begin_stage(engine, stage);
  const Energies before = energies_of(engine);
  while (!run.finished) continue_stage(engine, stage, run);
  const Energies e = energies_of(engine);
  const double kept = e.kinetic + e.elastic - before.kinetic - before.elastic;
  const double lost = e.dissipated_normal + e.dissipated_friction + e.dissipated_drag;
  EXPECT_GT(std::abs(e.work_walls), 1e-4);
  EXPECT_GT(std::abs(e.work_gravity), 1e-6);
  EXPECT_NEAR(kept + lost, e.work_walls + e.work_gravity, 1e-5 * (std::abs(e.work_walls) + lost));
}

TEST(Programme, ResumesToTheSameBits) {
  Packing start = crowd(10, 10, 3, 0.0125);
  start.domain.periodic[0] = start.domain.periodic[1] = true;
  for (Wall& wall : start.domain.wall) wall.present = false;
  Stage stage = stage_with({{pressure_on(top), {{0, 1e5}, {0.002, 1e6}, {0.003, 5e5}}, true},
                            {velocity_of(right), {{0, 0}, {0.002, 0.5}}},
                            {{What::shear_rate}, {{0, 0}, {0.001, 20}, {0.001, -20}}}},
                           0.004);
  Engine whole(start, {}, {}), cut(start, {}, {});
  whole.advance(100);
  cut.advance(100);
  const std::vector<std::uint8_t> at_start = save_sample(cut);
  StageRun one = begin_stage(whole, stage);
  while (!one.finished) continue_stage(whole, stage, one);

  StageRun first = begin_stage(cut, stage);
  for (int k = 0; k < 7; ++k) continue_stage(cut, stage, first);
  ASSERT_FALSE(first.finished);
  const auto bytes = save_sample(cut);
  Engine again(start, {}, {});
  restore_sample(again, at_start);
  StageRun second = begin_stage(again, stage);
  restore_sample(again, bytes);
  second.steps_in_increment = first.steps_in_increment;
  second.checks = first.checks;
  second.result = first.result;
  while (!second.finished) continue_stage(again, stage, second);
  EXPECT_EQ(state_hash(again), state_hash(whole));
  EXPECT_NEAR(whole.sheared, 0.01 - 0.06, 1e-4);
}

/// A plate by tables of its place, its angle, its velocity, and of the force on it.
TEST(Programme, MovesABoundary) {
  Packing start = empty_container(0.2, 0.2);
  add_grain(start, 0.02, 0.02, 0.005);
  Boundary plate;
  plate.name = "plate";
  plate.points = {{0.08, 0.1}, {0.12, 0.1}};
  plate.centre = {0.1, 0.1};
  start.domain.boundaries.push_back(plate);
  const auto of = [](What what, std::vector<Vec2> table, bool repeat = false) {
    return Programme{{what}, std::move(table), repeat, "plate"};
  };
  const auto moved = [&](Stage stage) {
    Engine engine(start, {}, {});
    StageRun run = begin_stage(engine, stage);
    while (!run.finished) continue_stage(engine, stage, run);
    return engine;
  };
  const Engine placed = moved(stage_with(
      {of(What::boundary_x, {{0, 0}, {0.001, 0.002}, {0.002, 0}}, true),
       of(What::boundary_velocity_y, {{0, 1}, {0.005, 1}}), of(What::boundary_angle, {{0, 0}, {0.005, 0.3}})},
      0.005));
  const double late = time_of(placed) - 0.005;
  const Boundary& there = placed.domain.boundaries[0];
  EXPECT_NEAR(there.centre.x - 0.1, 2 * (0.001 - late), 1e-12);
  EXPECT_NEAR(there.centre.y - 0.1, 0.005 + late, 1e-12);
  const Vec2 along = there.points[1] - there.points[0];
  EXPECT_NEAR(std::atan2(along.y, along.x), 0.3, 1e-9);
  EXPECT_NEAR(norm(along), 0.04, 1e-12);

  Stage pushed = stage_with({of(What::boundary_force_x, {{0, 2}, {0.005, 0}})}, 0.005);
  pushed.boundaries = {{"plate", {}, 0, {}, false, 0.5, {2, 0}}};
  const Engine thrown = moved(pushed);
  EXPECT_NEAR(packing_of(thrown).domain.boundaries[0].velocity.x, 0.5 * 2 * 0.005 / 0.5, 1e-8);
  EXPECT_NEAR(thrown.domain.boundaries[0].centre.x - 0.1,
              2 / 0.5 * 0.005 * 0.005 / 3 + 0.01 * (time_of(thrown) - 0.005), 1e-9);
}

}  // namespace
}  // namespace arenite::dem
