#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/rim.hpp"
#include "shapes.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;

TEST(Polygons, AreaAndInertiaOfARoundedSquareAreTheClosedForm) {
  const double a = 2, r = 0.3;  // a square of side a, widened by r
  const Shape shape{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, {r, r, r, r}, true};
  const geometry::Moments m = geometry::moments_within(rim_of(shape));
  EXPECT_NEAR(m.area, a * a + 4 * a * r + pi * r * r, 1e-13);
  EXPECT_NEAR(norm(m.centre), 0, 1e-15);
  // Square, four strips, four quarter disks about their corners: a quarter disk's centroid is 4 r/3 pi off the corner
  // both ways.
  const double strip = a * r * ((a * a + r * r) / 12 + std::pow((a + r) / 2, 2)), quarter = pi * r * r / 4,
               off = 4 * r / (3 * pi);
  const double corner = pi * r * r * r * r / 8 + quarter * (2 * std::pow(a / 2 + off, 2) - 2 * off * off);
  EXPECT_NEAR(m.polar, std::pow(a, 4) / 6 + 4 * strip + 4 * corner, 1e-12);
  const Shape equal = scaled_to(packing::PolygonShape{5, 1.7, 0.2}.make(), 1);
  EXPECT_NEAR(geometry::moments_within(rim_of(equal)).area, pi, 1e-13);
  EXPECT_NEAR(equal.radius.front(), 0.2, 1e-13);
}

TEST(Polygons, CollisionKeepsMomentumAndAngularMomentum) {
  for (const double restitution : {1.0, 0.5}) {
    Packing p = box(1, 1);
    add(p, Polygon{4, {0.3, 0.4}, 0.4, {1.5, -0.7}, 60});
    add(p, Polygon{3, {0.317, 0.404}, -1, {-1, 0.2}, -45});
    dem::ContactParameters law;
    law.friction = restitution < 1 ? 0.5 : 0;
    law.restitution = restitution;
    dem::IntegrationParameters how;
    how.safety = 0.02;
    Engine engine(p, law, how);
    const MotionOfAll before = motion_of(packing_of(engine));
    std::size_t most = 0;
    for (int n = 0; n < 800; ++n) {
      engine.advance(20);
      most = std::max(most, packing_of(engine).contacts.size());
      const MotionOfAll now = motion_of(packing_of(engine));
      ASSERT_NEAR(now.momentum.x / before.momentum.x, 1, 1e-12);
      ASSERT_NEAR(now.momentum.y / before.momentum.y, 1, 1e-12);
      ASSERT_NEAR(now.angular / before.angular, 1, 1e-12);
    }
    EXPECT_GT(most, 0U);
    EXPECT_EQ(packing_of(engine).contacts.size(), 0U);
    if (restitution == 1) EXPECT_NEAR(motion_of(packing_of(engine)).kinetic / before.kinetic, 1, 1e-3);
    else EXPECT_LT(motion_of(packing_of(engine)).kinetic, 0.95 * before.kinetic);
  }
}

/// The upper one stands on the lower one, half a millimetre to the side; both have friction and dashpots.
TEST(Polygons, TwoSquaresRestOnEachOther) {
  Packing p = box(0.2, 0.2);
  add(p, Polygon{4, {0.1, 0}, 0});
  const double half = half_side(p, 0), r = rounding(p, 0), own_weight = mass(p, 0) * gravity;
  p.grains.position[0].y = half + r;
  add(p, Polygon{4, {0.1005, 3 * half + 3 * r}, 0});
  dem::ContactParameters law;
  law.restitution = 0.2;
  Engine engine(p, law, {});
  set_gravity(engine, {0, -gravity});
  while (time_of(engine) < 0.1) engine.advance(200);
  const Packing first = packing_of(engine);
  while (time_of(engine) < 0.3) engine.advance(200);
  const Packing end = packing_of(engine);
  double on_wall = 0, between = 0;
  std::size_t walls = 0;
  for (std::size_t c = 0; c < end.contacts.size(); ++c) {
    if (end.contacts.is_wall(c)) on_wall += end.contacts.fn[c], ++walls;
    else between += dot(end.contacts.force_on_i(c), {0, 1});
  }
  EXPECT_EQ(walls, 2U);
  EXPECT_EQ(end.contacts.size(), 4U);  // a corner of each on the other's side
  EXPECT_NEAR(on_wall / (2 * own_weight), 1, 1e-9);
  EXPECT_NEAR(-between / own_weight, 1, 1e-9);
  for (std::size_t g = 0; g < 2; ++g) {
    EXPECT_NEAR(end.grains.position[g].x, first.grains.position[g].x, 1e-12);
    EXPECT_NEAR(end.grains.position[g].y, first.grains.position[g].y, 1e-12);
    EXPECT_NEAR(end.grains.position[g].x, p.grains.position[g].x, 1e-8);
    EXPECT_NEAR(end.grains.angle[g], 0, 1e-6);
    EXPECT_LT(std::abs(end.grains.velocity[g].y) + std::abs(end.grains.velocity[g].x), 1e-9);
  }
  // Its weight acts 0.5 mm off the middle of the two contacts, which are 2 half - 0.5 mm apart.
  const double apart = 2 * half - 0.5e-3;
  for (std::size_t c = 0; c < end.contacts.size(); ++c)
    if (!end.contacts.is_wall(c)) {
      const bool left_one = end.grains.position[0].x + end.contacts.lever_i(c).x < 0.1;
      EXPECT_NEAR(end.contacts.fn[c] / own_weight, 0.5 + (left_one ? -1 : 1) * 0.25e-3 / apart, 1e-5);
    }
  EXPECT_LT(equilibrium_of(engine).unbalanced_ratio, 1e-6);
}

TEST(Polygons, ASquareSlidesAboveTheAngleOfFriction) {
  const double mu = 0.4;
  for (const double slope : {0.95 * std::atan(mu), 1.1 * std::atan(mu)}) {
    Packing p = box(2, 1);
    add(p, Polygon{4, {0.1, 0}});
    p.grains.position[0].y = half_side(p, 0) + rounding(p, 0);
    dem::ContactParameters law;
    law.friction = mu;
    law.restitution = 0.2;
    Engine engine(p, law, {});
    set_gravity(engine, gravity * Vec2{std::sin(slope), -std::cos(slope)});
    while (time_of(engine) < 0.1) engine.advance(100);
    const Packing first = packing_of(engine);
    const double then = time_of(engine);
    while (time_of(engine) < 0.2) engine.advance(100);
    const Packing end = packing_of(engine);
    const double acceleration = (end.grains.velocity[0].x - first.grains.velocity[0].x) / (time_of(engine) - then);
    if (slope < std::atan(mu)) EXPECT_NEAR(end.grains.velocity[0].x, 0, 1e-8);
    else EXPECT_NEAR(acceleration / (gravity * (std::sin(slope) - mu * std::cos(slope))), 1, 1e-6);
    EXPECT_EQ(end.contacts.size(), 2U);
  }
}

/// Corner on side, side on side and corner on corner.
TEST(Polygons, ForceIsMinusTheGradientOfTheEnergy) {
  const dem::ContactParameters law = elastic();
  struct Pose {
    Vec2 place;
    double angle;
    std::size_t contacts;
  };
  Packing alone = box(1, 1);
  add(alone, Polygon{});
  const double half = half_side(alone, 0), r = rounding(alone, 0), deep = 1e-5,
               diagonal = (2 * r - deep) / std::sqrt(2);
  const Pose poses[] = {{{0.3 + half + 2 * r + half * std::sqrt(2.0) - deep, 0.4003}, pi / 4, 1},
                        {{0.3 + 2 * half + 2 * r - deep, 0.4011}, 1e-4, 2},
                        {{0.3 + 2 * half + diagonal, 0.4 + 2 * half + diagonal}, 0.002, 2}};
  for (const Pose& pose : poses) {
    Packing p = box(1, 1);
    add(p, Polygon{4, {0.3, 0.4}});
    add(p, Polygon{4, pose.place, pose.angle});
    dem::IntegrationParameters how;
    how.safety = 1e-4;
    const auto energy = [&](double dx, double dy, double turn) {
      Packing moved = p;
      moved.grains.position[1].x += dx;
      moved.grains.position[1].y += dy;
      moved.grains.angle[1] += turn;
      return energies_of(Engine(moved, law, how)).elastic;
    };
    Engine engine(p, law, how);
    EXPECT_EQ(packing_of(engine).contacts.size(), pose.contacts);
    const double dt = engine.dt, m = mass(p, 1), inertia = m * std::pow(p.grains.shapes.gyration[1], 2);
    engine.advance(1);
    set_gravity(engine, {1e-30, 0});
    const Packing end = packing_of(engine);
    const double h = 1e-9, turn = h / half;
    const Vec2 force{-(energy(h, 0, 0) - energy(-h, 0, 0)) / (2 * h), -(energy(0, h, 0) - energy(0, -h, 0)) / (2 * h)};
    const double torque = -(energy(0, 0, turn) - energy(0, 0, -turn)) / (2 * turn);
    ASSERT_GT(norm(force), 1);
    // Velocities are those of the end of the step: half the force of its start, half that of its end.
    EXPECT_NEAR(m * end.grains.velocity[1].x / dt, force.x, 1e-5 * norm(force));
    EXPECT_NEAR(m * end.grains.velocity[1].y / dt, force.y, 1e-5 * norm(force));
    EXPECT_NEAR(inertia * end.grains.omega[1] / dt, torque, 1e-5 * half * norm(force));
  }
}

/// Energy and force run on without a jump where a corner slides off the end of a side.
TEST(Polygons, ForceIsContinuousWhereASideEnds) {
  Packing alone = box(1, 1);
  add(alone, Polygon{});
  const double half = half_side(alone, 0), r = rounding(alone, 0);
  const auto force = [&](double beyond) {
    Packing p = box(1, 1);
    add(p, Polygon{4, {0.3, 0.4}});
    add(p, Polygon{4, {0.3 + half + beyond, 0.4 + half + half * std::sqrt(2.0) + 2 * r - 1e-5}, pi / 4});
    Vec2 sum;
    const Packing now = packing_of(Engine(p, elastic(), {}));
    for (std::size_t c = 0; c < now.contacts.size(); ++c) sum += now.contacts.force_on_i(c);
    return sum;
  };
  const Vec2 before = force(-1e-9), after = force(1e-9);
  EXPECT_GT(norm(before), 100);
  EXPECT_LT(norm(after - before), 1e-4 * norm(before));
}

}  // namespace
}  // namespace arenite::verification
