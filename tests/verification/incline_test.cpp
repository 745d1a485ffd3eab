#include <gtest/gtest.h>

#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;
using dem::FrictionLaw;

constexpr double radius = 6.2e-3;

/// A disk on the bottom wall at the overlap that carries its weight, the gravity tilted by `slope` towards +x.
struct Incline {
  double slope;
  Packing start = box(20, 1);
  double m, overlap;

  explicit Incline(double angle) : slope(angle) {
    add(start, {{1, radius}, radius});
    m = mass(start, 0);
    overlap = m * gravity * std::cos(slope) / k_pom;
    start.grains.position[0].y -= overlap;
  }
  double step() const { return contact_time(m, k_pom) / 100; }
  Vec2 pull() const { return gravity * Vec2{std::sin(slope), -std::cos(slope)}; }
  Engine engine(const dem::ContactParameters& law, bool rotations = true) const {
    dem::IntegrationParameters how = with_step(step());
    how.rotations = rotations;
    Engine e(start, law, how);
    set_gravity(e, pull());
    return e;
  }
};

dem::ContactParameters rough(FrictionLaw law, double mu) {
  dem::ContactParameters c;
  c.friction_law = law;
  c.friction = mu;
  c.restitution = 0.3;
  return c;
}

const FrictionLaw laws[] = {dem::RegularisedCoulomb{}, dem::CundallStrack{}};

struct Acceleration {
  double linear, angular;
};
/// Mean over the second half of `steps`, when what the start had of transients is gone.
Acceleration measured(Engine& engine, std::int64_t steps) {
  engine.advance(steps / 2);
  const Packing a = packing_of(engine);
  engine.advance(steps / 2);
  const Packing b = packing_of(engine);
  const double t = static_cast<double>(steps / 2) * engine.dt;
  return {(b.grains.velocity[0].x - a.grains.velocity[0].x) / t, (b.grains.omega[0] - a.grains.omega[0]) / t};
}

TEST(Incline, ASlidingBlockAcceleratesByGSinMinusMuCos) {
  for (const auto friction : laws)
    for (const double mu : {0.1, 0.4}) {
      const Incline incline(std::atan(mu) + 0.2);
      Engine engine = incline.engine(rough(friction, mu), false);
      const double a = gravity * (std::sin(incline.slope) - mu * std::cos(incline.slope));
      EXPECT_NEAR(measured(engine, 80000).linear, a, 1e-6 * a);
      EXPECT_EQ(packing_of(engine).grains.omega[0], 0);
    }
}

TEST(Incline, ADiskSlidesAndTurnsBeyondThreeTimesTheFrictionAngle) {
  for (const auto friction : laws) {
    const double mu = 0.2;
    const Incline incline(std::atan(3 * mu) + 0.2);
    Engine engine = incline.engine(rough(friction, mu));
    const double a = gravity * (std::sin(incline.slope) - mu * std::cos(incline.slope));
    const double turn = mu * gravity * std::cos(incline.slope) * incline.m * (radius - incline.overlap) /
                        disk_inertia(incline.start, 0);
    const Acceleration is = measured(engine, 80000);
    EXPECT_NEAR(is.linear, a, 1e-6 * a);
    EXPECT_NEAR(is.angular, -turn, 1e-6 * turn);  // down the slope towards +x: clockwise
  }
}

TEST(Incline, ADiskRollsWithTwoThirdsOfGSin) {
  // With the arm r - h to the plane: g sin/(1 + r^2/(2 (r - h)^2)), two thirds up to h/r = 1e-6.
  for (const auto friction : laws) {
    const Incline incline(0.3);
    dem::ContactParameters law = rough(friction, 0.5);
    law.sliding_viscosity = 50;
    Engine engine = incline.engine(law);
    const Acceleration is = measured(engine, 200000);
    const double a = 2.0 / 3 * gravity * std::sin(incline.slope);
    // A Cundall-Strack spring swings about the rolling force; its mean, not its phase, is what is held here.
    const double tolerance = friction == dem::CundallStrack{} ? 1e-3 : 1e-5;
    EXPECT_NEAR(is.linear, a, tolerance * a);
    EXPECT_NEAR(is.angular, -a / radius, tolerance * a / radius);
    if (friction == dem::RegularisedCoulomb{}) {
      // The viscous law rolls with the slip that its friction force needs: m g sin/3 = gamma_s v_s.
      const Packing p = packing_of(engine);
      const double slip = p.grains.velocity[0].x + p.grains.omega[0] * (radius - incline.overlap);
      const double expected = incline.m * gravity * std::sin(incline.slope) / 3 / 50;
      EXPECT_NEAR(slip, expected, 1e-4 * expected);
    }
  }
}

TEST(Incline, RegularisedFrictionHoldsNoStaticFrictionButCreeps) {
  const Incline incline(0.2);
  dem::ContactParameters law = rough(dem::RegularisedCoulomb{}, 0.5);
  law.sliding_viscosity = 50;
  Engine engine = incline.engine(law, false);
  engine.advance(60000);  // many times m/gamma_s
  const double creep = incline.m * gravity * std::sin(incline.slope) / 50;
  EXPECT_NEAR(packing_of(engine).grains.velocity[0].x, creep, 1e-8 * creep);
}

TEST(Incline, ACundallStrackBlockSticksAtTheSpringsStretch) {
  const Incline incline(0.2);
  Engine engine = incline.engine(rough(dem::CundallStrack{}, 0.5), false);
  set_drag(engine, 0.2 * std::sqrt(k_pom / incline.m));
  engine.advance(20000);
  const double moved_by = incline.m * gravity * std::sin(incline.slope) / (0.8 * k_pom);
  const Packing p = packing_of(engine);
  // The spring sums sliding velocities by the trapezoidal rule: (omega_t dt)^2/4 of the stretch.
  const double omega_t_dt = std::sqrt(0.8 * k_pom / incline.m) * incline.step();
  EXPECT_NEAR(p.grains.position[0].x - 1, moved_by, 0.3 * omega_t_dt * omega_t_dt * moved_by);
  EXPECT_NEAR(p.grains.velocity[0].x, 0, 1e-9);
  ASSERT_EQ(p.contacts.size(), 1u);
  const double force = dot(p.contacts.force_on_i(0), {1, 0});
  EXPECT_NEAR(force, -incline.m * gravity * std::sin(incline.slope), 1e-6 * std::abs(force));
}

TEST(Incline, ACundallStrackBlockLeavesWhenTheSlopePassesMu) {
  const double mu = 0.3;
  for (const double excess : {-0.02, 0.02}) {
    const Incline incline(std::atan(mu) + excess);
    Engine engine = incline.engine(rough(dem::CundallStrack{}, mu), false);
    set_gravity(engine, {0, -gravity * std::cos(incline.slope)});
    set_drag(engine, 0.2 * std::sqrt(k_pom / incline.m));
    for (int part = 1; part <= 50; ++part) {  // tilted slowly, so that no overshoot decides
      set_gravity(engine, {part / 50.0 * incline.pull().x, incline.pull().y});
      engine.advance(400);
    }
    set_drag(engine, 0);
    engine.advance(20000);
    const double v = packing_of(engine).grains.velocity[0].x;
    if (excess < 0) EXPECT_LT(std::abs(v), 1e-8);
    else EXPECT_GT(v, 1e-4);
  }
}

TEST(Incline, WallFrictionIsItsOwnParameter) {
  const double mu = 0.25;
  const Incline incline(std::atan(mu) + 0.3);
  dem::ContactParameters law = rough(dem::RegularisedCoulomb{}, 5);
  law.wall_friction = mu;
  Engine engine = incline.engine(law, false);
  const double a = gravity * (std::sin(incline.slope) - mu * std::cos(incline.slope));
  EXPECT_NEAR(measured(engine, 80000).linear, a, 1e-6 * a);
}

}  // namespace
}  // namespace arenite::verification
