#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/run_stage.hpp"
#include "unit/grains/dem/boundaries/containers.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

TEST(Boundaries, TurningPlateCarriesADiskAndItsWorkIsBooked) {
  // A plate that begins to turn about a point of it; a disk rests on it, held by friction.
  Boundary plate = polyline({{0.5, 1}, {1.5, 1}});
  Packing p = container_with(plate);
  const double x = 1.1, weight = mass_of(r) * g, spin = 0.2;
  testing::add_grain(p, x, 1 + r - overlap_under(weight), r);
  ContactParameters contact = with_friction(1);
  contact.rolling = ElasticPlasticRolling{0.5, 0.3};
  IntegrationParameters integration;
  integration.track_energy = true;
  Engine engine(p, contact, integration);
  set_gravity(engine, {0, -g});
  set_boundaries(engine, {{"plate", {}, spin, Vec2{1, 1}}});
  while (time_of(engine) < 0.5) engine.advance(100);
  const double turned = spin * time_of(engine);
  const Packing now = packing_of(engine);
  const Vec2 along{std::cos(turned), std::sin(turned)}, at = Vec2{1, 1} + 0.1 * along + r * perpendicular(along);
  EXPECT_NEAR(now.grains.position[0].x, at.x, 2e-5);
  EXPECT_NEAR(now.grains.position[0].y, at.y, 2e-5);
  EXPECT_NEAR(now.grains.omega[0], spin, 1e-3 * spin);
  EXPECT_NEAR(norm(now.domain.boundaries[0].points[1] - Vec2{1, 1}), 0.5, 1e-10);
  EXPECT_NEAR(now.domain.boundaries[0].points[1].y, 1 + 0.5 * std::sin(turned), 1e-9);
  EXPECT_NEAR(now.domain.boundaries[0].torque, -weight * (at.x - 1), 0.01 * weight * 0.1);
  const Energies e = energies_of(engine);
  const double gained = e.kinetic + e.elastic + e.dissipated_normal + e.dissipated_friction - e.work_gravity;
  EXPECT_NEAR(e.work_walls, weight * (at.y - 1 - r), 0.01 * e.work_walls);
  EXPECT_NEAR(gained, e.work_walls, 1e-4 * e.work_walls + 1e-9);
}

TEST(Boundaries, IntruderGivesItsMomentum) {
  // A wedge at constant speed hits a disk at rest: it leaves with (1 + e) times the speed along the normal.
  Boundary intruder = polyline({{0.5, 0.9}, {0.6, 1.0}, {0.5, 1.1}}, true);
  Packing p = container_with(intruder);
  testing::add_grain(p, 0.6 + r + 0.001, 1, r);
  Engine engine(p, with_friction(0, 0.5), {});
  set_boundaries(engine, {{"plate", {1, 0}, 0, intruder.centre}});
  double impulse = 0;
  while (time_of(engine) < 0.01) {
    const double from = time_of(engine);
    engine.advance(1);
    impulse += engine.domain.boundaries[0].force.x * (time_of(engine) - from);
  }
  const Packing now = packing_of(engine);
  EXPECT_NEAR(now.grains.velocity[0].x, 1.5, 0.02);
  EXPECT_NEAR(impulse, -mass_of(r) * now.grains.velocity[0].x, 1e-3 * mass_of(r));
  EXPECT_NEAR(now.domain.boundaries[0].points[1].x, 0.6 + time_of(engine), 1e-12);
}

TEST(Boundaries, DrumHoldsItsGrainsAndItsEnergyIsAccounted) {
  const Packing p = crowded_drum();
  IntegrationParameters integration;
  integration.track_energy = true;
  Engine engine(p, with_friction(0.5), integration);
  const double before = energies_of(engine).elastic;
  set_gravity(engine, {0, -g});
  const Vec2 middle = p.domain.boundaries[0].centre;
  set_boundaries(engine, {{"plate", {}, 5, middle}});
  while (time_of(engine) < 0.1) engine.advance(1000);
  const Packing now = packing_of(engine);
  for (std::size_t k = 0; k < now.grains.size(); ++k)
    EXPECT_LT(norm(now.grains.position[k] - middle) + 0.9 * now.grains.radius[k], 0.18);
  const Energies e = energies_of(engine);
  const double open =
      e.kinetic + e.elastic + e.dissipated_normal + e.dissipated_friction - before - e.work_gravity - e.work_walls;
  EXPECT_GT(e.work_walls, 0);
  EXPECT_NEAR(open / (e.dissipated_normal + e.dissipated_friction), 0, 1e-3);  // walls alone: -5e-4
}

TEST(Boundaries, GateThatGoesLetsItsGrainFallAndOpenSideLetsItOut) {
  Packing p = container_with(polyline({{0.5, 1}, {1.5, 1}}));
  testing::add_grain(p, 1, 1 + r, r);
  Engine engine(p, with_friction(0.5), {});
  set_gravity(engine, {0, -g});
  while (time_of(engine) < 0.1) engine.advance(100);
  EXPECT_NEAR(packing_of(engine).grains.position[0].y, 1 + r, 1e-5);
  set_boundaries(engine, {{"plate", {}, 0, Vec2{1, 1}, true}});
  set_open(engine, {false, false, true, false});
  const double then = time_of(engine);
  while (time_of(engine) < then + 0.6) engine.advance(100);
  const double fallen = time_of(engine) - then;
  EXPECT_NEAR(packing_of(engine).grains.position[0].y, 1 + r - 0.5 * g * fallen * fallen, 1e-4);
  EXPECT_LT(packing_of(engine).grains.position[0].y, 0);
  EXPECT_EQ(amount_below(engine, 0).grains, 1u);
  EXPECT_NEAR(amount_below(engine, 0).mass, mass_of(r), 1e-12);
  EXPECT_THROW(set_open(engine, {}), InputError);
  Engine again(p, with_friction(0.5), {});
  restore_sample(again, save_sample(engine));
  again.advance(100);
  engine.advance(100);
  EXPECT_EQ(state_hash(again), state_hash(engine));
}

TEST(Boundaries, StagesMoveThemByName) {
  Packing p = container_with(polyline({{0.5, 1}, {1.5, 1}}));
  testing::add_grain(p, 1, 1 + r, r);
  Engine engine(p, with_friction(0.5), {});
  Stage stage;
  stage.name = "lift";
  stage.duration = 0.1;
  stage.boundaries = {{"plate", {0, 0.5}, 0, {}, false}};
  stage.count_below = 1.5;
  StageRun run = begin_stage(engine, stage);
  while (!run.finished) continue_stage(engine, stage, run);
  EXPECT_NEAR(engine.domain.boundaries[0].points[0].y, 1 + 0.5 * time_of(engine), 1e-9);
  const auto& columns = run.result.history.columns;
  const auto has = [&](const char* name) {
    return std::any_of(columns.begin(), columns.end(), [&](const auto& c) { return c.name == name; });
  };
  EXPECT_TRUE(has("plate_force_x") && has("plate_force_y") && has("plate_torque") && has("passed") &&
              has("passed_mass"));
  stage.boundaries[0].name = "gate";
  EXPECT_THROW(begin_stage(engine, stage), InputError);
}

/// What a boundary does to a disk does not depend on where the cell is cut.
TEST(Boundaries, AnIntruderGoesOnThroughPeriodicSides) {
  const auto pushed = [](double from) {
    Packing p = testing::empty_container(0.2, 0.4);
    p.domain.periodic[0] = true;
    Boundary intruder = polyline({{from, 0.18}, {from + 0.02, 0.2}, {from, 0.22}}, true);
    p.domain.boundaries.push_back(intruder);
    testing::add_grain(p, std::fmod(from + 0.06, 0.2), 0.205, r);
    Engine engine(p, with_friction(0.3), {});
    set_boundaries(engine, {{"plate", {3, 0}, 0, intruder.centre}});
    while (time_of(engine) < 0.06) engine.advance(50);
    EXPECT_GE(engine.domain.boundaries[0].centre.x, -1e-3);
    EXPECT_LE(engine.domain.boundaries[0].centre.x, 0.2 + 1e-3);
    return packing_of(engine).grains;
  };
  const Grains a = pushed(0.03), b = pushed(0.15);
  EXPECT_GT(a.velocity[0].x, 1);
  EXPECT_NEAR(a.velocity[0].x, b.velocity[0].x, 1e-8);
  EXPECT_NEAR(a.velocity[0].y, b.velocity[0].y, 1e-8);
  EXPECT_NEAR(std::remainder(b.position[0].x - a.position[0].x - 0.12, 0.2), 0, 1e-8);
}

TEST(Boundaries, OneWithAMassBouncesOffADiskAndFalls) {
  ContactParameters elastic = with_friction(0, 1);
  elastic.normal_damping = 0;
  for (const IntegratorKind kind : {IntegratorKind::velocity_verlet, IntegratorKind::leapfrog}) {
    Packing p = container_with(polyline({{1, 0.5}, {1, 1.5}}));
    testing::add_grain(p, 0.989, 1, r);
    p.grains.velocity[0].x = 1;
    IntegrationParameters integration;
    integration.integrator = kind;
    integration.safety = 0.0005;
    integration.track_energy = true;
    Engine engine(p, elastic, integration);
    const double m = mass_of(r), mass = 3 * m;
    set_boundaries(engine, {{"plate", {-0.5, 0}, 0, Vec2{1, 1}, false, mass}});
    const Energies before = energies_of(engine);
    EXPECT_NEAR(before.kinetic, 0.5 * m + 0.5 * mass * 0.25, 1e-12);
    while (time_of(engine) < 0.002) engine.advance(50);
    const double common = (m - 0.5 * mass) / (m + mass);
    EXPECT_NEAR(packing_of(engine).grains.velocity[0].x, 2 * common - 1, 1e-6);
    EXPECT_NEAR(packing_of(engine).domain.boundaries[0].velocity.x, 2 * common + 0.5, 1e-6);
    set_gravity(engine, {0, -g});
    const double then = time_of(engine), place = engine.domain.boundaries[0].centre.y;
    const auto bytes = save_sample(engine);
    while (time_of(engine) < then + 0.002) engine.advance(50);
    const double fallen = time_of(engine) - then;
    EXPECT_NEAR(packing_of(engine).domain.boundaries[0].velocity.y, -g * fallen, 1e-9);
    EXPECT_NEAR(engine.domain.boundaries[0].centre.y - place, -0.5 * g * fallen * fallen, 1e-9);
    const Energies e = energies_of(engine);
    EXPECT_NEAR(e.kinetic + e.elastic - before.kinetic, e.work_gravity + e.work_walls - before.work_walls,
                1e-6 * before.kinetic);
    const std::uint64_t hash = state_hash(engine);
    const std::int64_t steps = engine.step;
    Engine again(p, elastic, integration);
    set_boundaries(again, {{"plate", {-0.5, 0}, 0, Vec2{1, 1}, false, mass}});
    set_gravity(again, {0, -g});
    restore_sample(again, bytes);
    again.advance(steps - again.step);
    EXPECT_EQ(state_hash(again), hash);
  }
  IntegrationParameters gear;
  gear.integrator = IntegratorKind::gear5;
  Packing p = container_with(polyline({{1, 0.5}, {1, 1.5}}));
  testing::add_grain(p, 0.5, 1, r);
  Engine engine(p, elastic, gear);
  EXPECT_THROW(set_boundaries(engine, {{"plate", {}, 0, {}, false, 1.0}}), InputError);
}

}  // namespace
}  // namespace arenite::dem
