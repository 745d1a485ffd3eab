#include <gtest/gtest.h>

#include <algorithm>

#include "shapes.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;

Boundary boundary(std::vector<Vec2> points, bool closed = false) {
  Boundary b;
  b.name = "plate";
  b.centre = mean_point(points);
  b.points = std::move(points);
  b.closed = closed;
  return b;
}

dem::ContactParameters rubbing(double mu, double restitution = 0.2) {
  dem::ContactParameters law;
  law.friction = mu;
  law.restitution = restitution;
  return law;
}

/// Slides down a plate of this slope that has points in between: its acceleration along the plate between 0.1 and 0.2
/// s, m/s^2.
template <class Grain> double acceleration_on(double slope, double mu, Grain grain, double above) {
  const Vec2 along{std::cos(slope), -std::sin(slope)}, up = perpendicular(along), start{0.2, 1.8};
  Packing p = box(2, 2);
  std::vector<Vec2> points;
  for (const double way : {0.0, 0.06, 0.102, 0.115, 0.13, 0.14, 0.16, 1.6}) points.push_back(start + way * along);
  p.domain.boundaries.push_back(boundary(points));
  grain.centre = start + 0.1 * along + above * up;
  grain.angle = -slope;
  add(p, grain);
  Engine engine(p, rubbing(mu), {});
  set_gravity(engine, {0, -gravity});
  while (time_of(engine) < 0.1) engine.advance(50);
  const double then = time_of(engine), before = dot(velocity(packing_of(engine), 0), along);
  while (time_of(engine) < 0.2) engine.advance(50);
  const Packing end = packing_of(engine);
  EXPECT_EQ(end.contacts.size(), 2U);
  return (dot(velocity(end, 0), along) - before) / (time_of(engine) - then);
}

TEST(BoundaryShapes, SlideAboveTheAngleOfFrictionPastPointsOfAStraightPlate) {
  const double mu = 0.4;
  Packing alone = box(1, 1);
  add(alone, Polygon{});
  const double square = half_side(alone, 0) + rounding(alone, 0);
  Packing clumps = box(1, 1);
  add(clumps, Clump{dumbbell, {}});
  const double disk = clumps.grains.shapes.radius[0];
  for (const double slope : {0.9 * std::atan(mu), 1.1 * std::atan(mu), 1.4 * std::atan(mu)}) {
    const double wanted = slope < std::atan(mu) ? 0 : gravity * (std::sin(slope) - mu * std::cos(slope));
    EXPECT_NEAR(acceleration_on(slope, mu, Polygon{}, square), wanted, 2e-6 * gravity) << slope;
    EXPECT_NEAR(acceleration_on(slope, mu, Clump{dumbbell, {}}, disk), wanted, 2e-6 * gravity) << slope;
  }
}

/// A square whose side lies on the tip of a wedge, the tip this far from the middle of the side.
Packing on_a_tip(double off, double turn = 0, double deep = 1e-5) {
  Packing p = box(1, 1);
  p.domain.boundaries.push_back(boundary({{0.4, 0.3}, {0.5, 0.4}, {0.6, 0.3}}));
  add(p, Polygon{});
  const double half = half_side(p, 0), r = rounding(p, 0);
  const Vec2 at{off, -(half + r - deep)};
  p.grains.position[0] = {0.5 - at.x, 0.4 - at.y};
  p.grains.angle[0] = turn;
  return p;
}

TEST(BoundaryShapes, ASideIsCarriedByATipThatJutsOut) {
  const Packing p = on_a_tip(1e-3);
  Engine engine(p, elastic(), {});
  const Packing now = packing_of(engine);
  ASSERT_EQ(now.contacts.size(), 1U);
  EXPECT_TRUE(now.contacts.is_boundary(0));
  EXPECT_EQ(now.contacts.element(0), 2);
  EXPECT_NEAR(now.contacts.overlap[0], 1e-5, 1e-12);
  EXPECT_NEAR(now.contacts.fn[0] / (k_pom * 1e-5), 1, 1e-6);
  EXPECT_NEAR(now.contacts.lever_i(0).x, 1e-3, 1e-12);
  EXPECT_NEAR(now.contacts.lever_i(0).y, 0.4 - p.grains.position[0].y, 1e-12);
  EXPECT_NEAR(engine.domain.boundaries[0].force.y, -now.contacts.fn[0], 1e-12 * now.contacts.fn[0]);
}

/// Tip on side, corner on side, and a corner beside the end of the plate.
TEST(BoundaryShapes, ForceIsMinusTheGradientOfTheEnergy) {
  Packing alone = box(1, 1);
  add(alone, Polygon{});
  const double half = half_side(alone, 0), r = rounding(alone, 0);
  Packing on_segment = on_a_tip(0);
  const Vec2 up{-std::sqrt(0.5), std::sqrt(0.5)}, along{std::sqrt(0.5), std::sqrt(0.5)};
  const Vec2 place = Vec2{0.4, 0.3} + 0.05 * along + (half * std::sqrt(2.0) + r - 1e-5) * up;
  on_segment.grains.position[0] = place;
  on_segment.grains.angle[0] = 0.002;
  Packing corner = on_a_tip(0);  // its corner and the tip meet each other twice
  corner.grains.position[0] = {0.5 + half + 0.6 * (r - 1e-5), 0.4 + half + 0.8 * (r - 1e-5)};
  struct Case {
    Packing packing;
    std::size_t contacts;
  };
  for (const Case& c : {Case{on_a_tip(1e-3, 0.01), 1}, Case{on_segment, 1}, Case{corner, 2},
                        Case{on_a_tip(half + 0.3e-3, 0, 0.1e-3), 2}}) {
    dem::IntegrationParameters how;
    how.safety = 1e-4;
    const auto energy = [&](double dx, double dy, double turn) {
      Packing moved = c.packing;
      moved.grains.position[0].x += dx;
      moved.grains.position[0].y += dy;
      moved.grains.angle[0] += turn;
      return energies_of(Engine(moved, elastic(), how)).elastic;
    };
    Engine engine(c.packing, elastic(), how);
    EXPECT_EQ(packing_of(engine).contacts.size(), c.contacts);
    const double dt = engine.dt, m = mass(c.packing, 0), inertia = m * std::pow(c.packing.grains.shapes.gyration[0], 2);
    engine.advance(1);
    set_gravity(engine, {1e-30, 0});
    const Packing end = packing_of(engine);
    const double h = 1e-9, turn = h / half;
    const Vec2 force{-(energy(h, 0, 0) - energy(-h, 0, 0)) / (2 * h), -(energy(0, h, 0) - energy(0, -h, 0)) / (2 * h)};
    const double torque = -(energy(0, 0, turn) - energy(0, 0, -turn)) / (2 * turn);
    ASSERT_GT(norm(force), 1);
    EXPECT_NEAR(m * end.grains.velocity[0].x / dt, force.x, 1e-5 * norm(force));
    EXPECT_NEAR(m * end.grains.velocity[0].y / dt, force.y, 1e-5 * norm(force));
    EXPECT_NEAR(inertia * end.grains.omega[0] / dt, torque, 1e-5 * half * norm(force));
  }
}

TEST(BoundaryShapes, ForceIsContinuousWhereASideSlidesOffATip) {
  Packing alone = box(1, 1);
  add(alone, Polygon{});
  const double half = half_side(alone, 0);
  const auto force = [&](double beyond) {
    return Engine(on_a_tip(half + beyond), elastic(), {}).domain.boundaries[0].force;
  };
  EXPECT_GT(norm(force(0)), 100);
  EXPECT_LT(norm(force(1e-9) - force(-1e-9)), 1e-4 * norm(force(0)));
}

TEST(BoundaryShapes, APointWithinAPolygonIsRefused) {
  const Packing p = on_a_tip(0, 0, 2e-3);
  try {
    Engine(p, elastic(), {});
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_NE(
        std::string(error.what()).find("a point of the boundary \"plate\" lies within polygon 0 before the first step"),
        std::string::npos)
        << error.what();
  }
}

/// Polygons and dumbbells in a drum of 24 sides, which has ribs that jut out.
Packing drum(int side) {
  const double pitch = 0.0172, radius = 0.5 * side * pitch, size = 2.01 * radius;
  const Vec2 middle{0.5 * size, 0.5 * size};
  Packing p = box(size, size);
  std::vector<Vec2> points;
  for (int n = 0; n < 24; ++n)
    points.push_back(middle + (n % 6 == 0 ? radius - 10e-3 : radius) * direction(2 * pi * n / 24));
  p.domain.boundaries.push_back(boundary(points, true));
  p.domain.boundaries.back().name = "drum";
  RandomStream random(3, Purpose::test);
  for (int q = 0; q < side * side; ++q) {
    const Vec2 at = middle + Vec2{(q % side + 0.5 - 0.5 * side) * pitch, (q / side + 0.5 - 0.5 * side) * pitch};
    const bool at_a_rib =
        std::any_of(points.begin(), points.end(), [&](Vec2 point) { return norm(at - point) < 8.5e-3; });
    if (at_a_rib || norm(at - middle) > std::cos(pi / 24) * radius - 9e-3) continue;
    const Vec2 v{random.uniform(-15, 15), random.uniform(-15, 15)};
    if (q % 3 == 0) add(p, Clump{dumbbell, at, 5e-3, random.uniform(0, 6), v, random.uniform(-50, 50)});
    else
      add(p, Polygon{3 + q % 4, at, random.uniform(0, 6), v, random.uniform(-50, 50), 5.5e-3, q % 2 == 0 ? 1.0 : 1.5,
                     0.15});
  }
  return p;
}

std::size_t met(const Packing& p) {
  std::size_t count = 0;
  for (std::size_t c = 0; c < p.contacts.size(); ++c) count += p.contacts.is_boundary(c);
  return count;
}

/// A drum that turns one way and comes to throw its grains about.
Engine turning(const Packing& p, const dem::IntegrationParameters& how) {
  Engine engine(p, rubbing(0.4, 0.4), how);
  set_gravity(engine, {0, -gravity});
  set_boundaries(engine, {{p.domain.boundaries[0].name, {1, -0.5}, 12, p.domain.boundaries[0].centre}});
  return engine;
}

/// Polygons and dumbbells pressed together by three walls and a plate with teeth.
Packing pressed_by_teeth() {
  const double pitch = 0.0172, size = 6 * pitch;
  Packing p = box(size, size);
  p.domain.wall[bottom].position = -0.03;
  std::vector<Vec2> points;
  for (int n = 0; n <= 12; ++n) points.push_back({0.5 * n * pitch, n % 2 == 0 ? -0.004 : -0.001});
  p.domain.boundaries.push_back(boundary(points));
  RandomStream random(5, Purpose::test);
  for (int q = 0; q < 36; ++q) {
    const Vec2 at{(q % 6 + 0.5) * pitch, (q / 6 + 0.5) * pitch}, v{random.uniform(-1, 1), random.uniform(-1, 1)};
    if (q % 3 == 0) add(p, Clump{dumbbell, at, 5.5e-3, random.uniform(0, 6), v, random.uniform(-50, 50)});
    else
      add(p, Polygon{3 + q % 4, at, random.uniform(0, 6), v, random.uniform(-50, 50), 5.5e-3, q % 2 == 0 ? 1.0 : 1.5,
                     0.15});
  }
  Engine engine(p, rubbing(0, 0.3), {});
  set_drives(engine, {moved(2), moved(-2), {}, moved(-2)});
  set_boundaries(engine, {{p.domain.boundaries[0].name, {0, 2}, 0, p.domain.boundaries[0].centre}});
  while (packing_of(engine).contacts.size() < 90) engine.advance(50);
  return packing_of(engine);
}

TEST(BoundaryShapes, EnergyIsClosedToAMillionthOfTheWorkAtAStepOfTcOver500) {
  const Packing p = pressed_by_teeth();
  dem::IntegrationParameters how;
  how.safety = 1.0 / 500;
  how.track_energy = true;
  Engine engine(p, rubbing(0.4, 0.4), how);
  set_drives(engine, {moved(0.8), moved(-0.8), {}, moved(-0.8)});
  set_boundaries(engine, {{p.domain.boundaries[0].name, {0.1, 0.8}, 1, p.domain.boundaries[0].centre}});
  const Energies before = energies_of(engine);
  EXPECT_GE(met(p), 4U);
  engine.advance(15'000);
  const Packing end = packing_of(engine);
  std::size_t teeth = 0;
  for (std::size_t c = 0; c < end.contacts.size(); ++c)
    teeth += end.contacts.is_boundary(c) && end.contacts.element(c) % 2 == 0;
  EXPECT_GE(teeth, 2U);
  const Energies after = energies_of(engine);
  const double stored = after.kinetic + after.elastic - before.kinetic - before.elastic,
               work = after.work_walls - before.work_walls;
  const double lost = after.dissipated_normal + after.dissipated_friction;
  EXPECT_GT(after.dissipated_friction, 0);
  EXPECT_GT(after.elastic, 5 * before.elastic);
  EXPECT_NEAR((stored + lost - work) / work, 0, 1e-6) << "work " << work << " lost " << lost << " stored " << stored;
}

TEST(BoundaryShapes, SameBitsOnOneAndTwoThreadsAndAfterARestart) {
  const Packing p = drum(56);  // enough grains for two threads
  ASSERT_GT(p.grains.size(), 2000U);
  std::uint64_t hash = 0;
  std::vector<std::uint8_t> half_way;
  for (const int threads : {1, 2}) {
    dem::IntegrationParameters how;
    how.threads = threads;
    Engine engine = turning(p, how);
    engine.advance(2011);
    half_way = save_sample(engine);
    std::size_t contacts = 0;
    for (int n = 0; n < 50; ++n) {
      engine.advance(10);
      contacts += met(packing_of(engine));
    }
    EXPECT_GT(contacts, 20U);
    if (hash == 0) hash = state_hash(engine);
    EXPECT_EQ(state_hash(engine), hash) << threads;
  }
  Engine resumed = turning(p, {});
  restore_sample(resumed, half_way);
  resumed.advance(500);
  EXPECT_EQ(state_hash(resumed), hash);
}

}  // namespace
}  // namespace arenite::verification
