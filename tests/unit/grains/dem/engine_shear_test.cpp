#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/dem/engine.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

Packing periodic_crowd(std::uint64_t seed) {
  Packing p = testing::crowd(10, 10, seed, 0.0122);
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  return p;
}

double balance(const Energies& now, const Energies& start) {
  const auto sum = [](const Energies& e) {
    return e.kinetic + e.elastic + e.dissipated_normal + e.dissipated_friction + e.dissipated_drag +
           e.dissipated_breakage - e.work_walls - e.work_gravity;
  };
  return sum(now) - sum(start);
}

IntegrationParameters tracked(double safety, IntegratorKind kind = IntegratorKind::velocity_verlet) {
  IntegrationParameters integration;
  integration.track_energy = true;
  integration.safety = safety;
  integration.integrator = kind;
  return integration;
}

TEST(ShearedCell, MovesFreeGrainsByTheShearAlone) {
  for (const auto kind : {IntegratorKind::velocity_verlet, IntegratorKind::gear5}) {
    Packing p = testing::empty_container(0.2, 0.2);
    p.domain.periodic[0] = p.domain.periodic[1] = true;
    testing::add_grain(p, 0.05, 0.19, 0.003);
    testing::add_grain(p, 0.15, 0.03, 0.003);
    p.grains.velocity[0].y = 1;  // crosses the upper edge
    IntegrationParameters integration;
    integration.integrator = kind;
    Engine engine(p, {}, integration);
    set_shear_rate(engine, 2);
    while (time_of(engine) < 0.3) engine.advance(100);
    const Packing now = packing_of(engine);
    const double t = time_of(engine);
    // In the plane of all images grain 0 goes on straight with the speed that its first height gave it; one image down,
    // it is slower by rate H.
    const Vec2 straight{0.05 + 2 * 0.09 * t, 0.19 + t};
    EXPECT_NEAR(norm(now.domain.nearest_image(now.grains.position[0] - straight)), 0, 1e-10);
    EXPECT_NEAR(now.grains.velocity[0].x, 2 * 0.09 - 2 * 0.2 * std::floor((0.19 + t) / 0.2), 1e-10);
    EXPECT_NEAR(norm(now.domain.nearest_image(now.grains.position[1] - Vec2{0.15 - 2 * 0.07 * t, 0.03})), 0, 1e-10);
    EXPECT_NEAR(engine.sheared, 2 * t, 1e-9);
    EXPECT_LE(std::abs(now.domain.tilt), 0.5 * now.domain.width() + 1e-12);
  }
}

TEST(ShearedCell, GivesTheSameMotionWhereverItsEdgesLie) {
  Packing p = periodic_crowd(3), q = p;
  const Vec2 shift{0.4 * p.domain.width(), 0.7 * p.domain.height()};
  for (std::size_t k = 0; k < q.grains.size(); ++k) {
    q.grains.position[k] = {std::fmod(q.grains.position[k].x + shift.x, q.domain.width()),
                            std::fmod(q.grains.position[k].y + shift.y, q.domain.height())};
  }
  Engine a(p, {}, {}), b(q, {}, {});
  set_shear_rate(a, 5);
  set_shear_rate(b, 5);
  a.advance(1500);
  b.advance(1500);
  const Packing pa = packing_of(a), pb = packing_of(b);
  // An image is as much faster as it is higher.
  const double height = p.domain.height();
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    const double up = pb.grains.position[k].y - pa.grains.position[k].y - shift.y;
    EXPECT_NEAR(up - std::round(up / height) * height, 0, 1e-7);
    const double faster =
        pb.grains.velocity[k].x - pa.grains.velocity[k].x - 5 * (pb.grains.position[k].y - pa.grains.position[k].y);
    EXPECT_NEAR(faster, 0, 1e-5);
  }
}

TEST(ShearedCell, ClosesItsEnergy) {
  for (const auto kind : {IntegratorKind::velocity_verlet, IntegratorKind::gear5}) {
    const Packing p = periodic_crowd(4);
    Engine engine(p, {}, tracked(0.002, kind));
    set_shear_rate(engine, 20);
    const Energies start = energies_of(engine);
    double t = 0;
    while (t < 0.01) engine.advance(500), t = time_of(engine);
    const Energies now = energies_of(engine);
    EXPECT_GT(now.work_walls, 0);
    EXPECT_NEAR(balance(now, start), 0, 1e-5 * (std::abs(now.work_walls) + start.elastic)) << now.work_walls;
  }
}

TEST(ShearedCell, GivesTheSameBitsOnTwoThreadsAndRestored) {
  const Packing p = testing::crowd(50, 50, 7, 0.0122);
  Packing periodic = p;
  periodic.domain.periodic[0] = periodic.domain.periodic[1] = true;
  IntegrationParameters one, two;
  two.threads = 2;
  Engine a(periodic, {}, one), b(periodic, {}, two), c(periodic, {}, one);
  for (Engine* e : {&a, &b}) {
    set_shear_rate(*e, 10);
    e->advance(2000);
  }
  EXPECT_EQ(state_hash(a), state_hash(b));
  restore_sample(c, save_sample(a));
  a.advance(300);
  c.advance(300);
  EXPECT_EQ(state_hash(a), state_hash(c));
}

TEST(SlidingWall, DragsAGrainUpToItsSpeed) {
  Packing p = testing::empty_container(10, 0.2);
  testing::add_grain(p, 1, 0.00999, 0.01);
  ContactParameters contact;
  contact.friction = 0.5;
  Engine engine(p, contact, {});
  set_gravity(engine, {0, -9.81});
  WallDrives drives;
  drives[bottom].slide = 0.3;
  set_drives(engine, drives);
  while (time_of(engine) < 1) engine.advance(100);
  const Packing now = packing_of(engine);
  // Friction gives m v and, about the centre, I omega = R m v with I = m R^2/2; sliding ends at v + R omega = 3 v =
  // 0.3.
  EXPECT_NEAR(now.grains.velocity[0].x, 0.1, 2e-4);
  EXPECT_NEAR(now.grains.velocity[0].x + now.grains.omega[0] * 0.01, 0.3, 1e-3);
}

TEST(RoughWall, CarriesTheGrainsNearIt) {
  const Packing p = testing::crowd(12, 12, 5, 0.0122);
  Packing cell = p;
  cell.domain.periodic[0] = true;
  Engine engine(cell, {}, tracked(0.01));
  WallDrives drives;
  drives[top] = {WallDrive::Kind::force, 2000};
  set_drives(engine, drives);
  engine.advance(4000);
  set_rough(engine, {false, false, true, true});
  const Packing before = packing_of(engine);
  drives[top].slide = 0.5;
  set_drives(engine, drives);
  const double t0 = time_of(engine);
  const Energies start = energies_of(engine);
  engine.advance(60000);
  double shear = 0, normal = 0;
  for (int look = 0; look < 100; ++look) {
    engine.advance(400);
    shear += engine.domain.wall[top].shear_force;
    normal += engine.domain.wall[top].force;
  }
  const double t = time_of(engine) - t0;
  const Packing now = packing_of(engine);
  int low = 0, high = 0;
  const double rise = now.domain.wall[top].position - before.domain.wall[top].position;
  for (std::size_t k = 0; k < now.grains.size(); ++k) {
    const double from_top = before.domain.wall[top].position - before.grains.position[k].y - before.grains.radius[k];
    if (before.grains.position[k].y < 1.5 * before.grains.radius[k]) {
      ++low;
      EXPECT_NEAR(norm(now.domain.nearest_image(now.grains.position[k] - before.grains.position[k])), 0, 1e-12);
    } else if (from_top < 0.5 * before.grains.radius[k]) {
      ++high;
      EXPECT_NEAR(
          norm(now.domain.nearest_image(now.grains.position[k] - before.grains.position[k] - Vec2{0.5 * t, rise})), 0,
          1e-9);
    }
  }
  EXPECT_GT(low, 3);
  EXPECT_GT(high, 3);
  const Energies end = energies_of(engine);
  EXPECT_NEAR(balance(end, start), 0, 2e-3 * (end.work_walls - start.work_walls)) << end.work_walls;
  EXPECT_LT(shear, -0.1 * normal)
      << shear / normal;  // grains between rough walls have a friction of 0.2 to 0.4; a state alone fluctuates
}

TEST(RoughWall, ThatHoldsNoGrainLeavesTheSpringsOfFrictionAsTheyAre) {
  Packing p = testing::crowd(8, 8, 5, 0.0122);
  for (Vec2& centre : p.grains.position) centre.y += 0.02;
  p.domain.wall[top].position += 0.02;
  Engine engine(p, {}, {});
  engine.advance(200);
  const Packing before = packing_of(engine);
  set_rough(engine, {false, false, true, false});
  const Packing after = packing_of(engine);
  ASSERT_EQ(after.contacts.size(), before.contacts.size());
  // Stages begin between steps, where velocities are brought up to the places: forces see that, which is not the
  // springs' way.
  set_rough(engine, {false, false, false, false});
  EXPECT_EQ(packing_of(engine).contacts.ft, after.contacts.ft);
}

}  // namespace
}  // namespace arenite::dem
