#include <gtest/gtest.h>

#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Arms;
using dem::Engine;
using dem::FrictionLaw;

// Slow enough that the line of centres does not turn while the disks touch; the linear law does not mind.
constexpr double normal_speed = 1e-3;

/// Two unequal disks of unlike material that meet along x with a tangential relative speed and spins; disk 0 comes
/// from the left. Returned before and after the contact.
struct Oblique {
  Packing before, after;
  double m_eff = 0, k = 0;
  double normal_impulse() const { return mass(before, 0) * (before.grains.velocity[0].x - after.grains.velocity[0].x); }
  double tangential_impulse() const {
    return mass(before, 0) * (before.grains.velocity[0].y - after.grains.velocity[0].y);
  }
};

Oblique run(double tangential_speed, dem::ContactParameters law, double spin0 = 0, double spin1 = 0,
            double steps_in_contact = 4000) {
  Oblique o;
  Packing p = box(1, 1);
  const double ra = 8.2e-3, rb = 5.25e-3;
  add(p, {{0.5, 0.5}, ra, pom, {0.6 * normal_speed, 0.3 * tangential_speed}, spin0});
  add(p, {{0.5 + ra + rb, 0.5}, rb, hdpe, {-0.4 * normal_speed, -0.7 * tangential_speed}, spin1});
  o.m_eff = reduced(mass(p, 0), mass(p, 1));
  o.k = reduced(k_pom, k_hdpe);
  const double tc = contact_time(o.m_eff, o.k), dt = tc / steps_in_contact;
  p.grains.position[1].x += 0.41 * normal_speed * dt;
  o.before = p;
  Engine engine(p, law, with_step(dt));
  engine.advance(static_cast<std::int64_t>(1.5 * steps_in_contact));
  o.after = packing_of(engine);
  EXPECT_EQ(o.after.contacts.size(), 0u);
  EXPECT_GT(o.normal_impulse(), 0);
  return o;
}

TEST(ObliqueCollision, ConservesMomentumAndAngularMomentumAboutAnyPoint) {
  for (const dem::FrictionLaw& friction :
       std::initializer_list<dem::FrictionLaw>{dem::RegularisedCoulomb{}, dem::CundallStrack{}}) {
    dem::ContactParameters law;
    law.friction_law = friction;
    law.restitution = 0.5;
    const Oblique o = run(6e-4, law, 0.04, -0.07);
    // Rounding only: the arms meet at one contact point, so the two torques and the couple of the force cancel.
    const double p0 = norm(mass(o.before, 0) * velocity(o.before, 0));
    EXPECT_NEAR(momentum(o.after).x, momentum(o.before).x, 1e-12 * p0);
    EXPECT_NEAR(momentum(o.after).y, momentum(o.before).y, 1e-12 * p0);
    for (const Vec2 about : {Vec2{0.5 + 8.2e-3, 0.5}, Vec2{0, 0}}) {
      const double scale = p0 * (8.2e-3 + norm(about - o.before.grains.position[0]));
      EXPECT_NEAR(angular_momentum(o.after, about), angular_momentum(o.before, about), 1e-11 * scale);
    }
    EXPECT_GT(std::abs(o.after.grains.omega[0] - 0.04), 2e-3);
  }
}

TEST(ObliqueCollision, FullRadiusArmsTurnTheDisksMoreByTheOverlapOnly) {
  dem::ContactParameters law;
  law.friction_law = dem::RegularisedCoulomb{};
  law.restitution = 0.5;
  law.arms = Arms::contact_point;
  const Oblique point = run(6e-4, law);
  law.arms = Arms::full_radius;
  const Oblique full = run(6e-4, law);
  const double change = full.after.grains.omega[0] / point.after.grains.omega[0] - 1;
  const double relative_overlap = normal_speed / std::sqrt(point.k / point.m_eff) / 5.25e-3;
  EXPECT_GT(std::abs(change), 1e-8);
  EXPECT_LT(std::abs(change), 2 * relative_overlap);
}

TEST(ObliqueCollision, SlidingThroughoutCarriesMuTimesTheNormalImpulse) {
  // Disks slide to the end if v_t > 3 mu (1 + e) v_n; the line of centres turns by some 1e-5.
  for (const dem::FrictionLaw& friction :
       std::initializer_list<dem::FrictionLaw>{dem::RegularisedCoulomb{}, dem::CundallStrack{}})
    for (const double mu : {0.1, 0.3, 0.7}) {
      dem::ContactParameters law;
      law.friction_law = friction;
      law.friction = mu;
      law.restitution = 1;
      law.normal_damping = 0;
      law.sliding_viscosity = 200;
      const Oblique o = run(14 * mu * normal_speed, law);
      EXPECT_NEAR(o.tangential_impulse() / o.normal_impulse(), mu, 1e-4 * mu) << "mu " << mu;
      const double r = 8.2e-3, turn = o.after.grains.omega[0] * disk_inertia(o.before, 0);
      EXPECT_NEAR(turn, -r * o.tangential_impulse(), 1e-4 * std::abs(r * o.tangential_impulse()));
    }
}

TEST(ObliqueCollision, FrictionStopsWhereTheDashpotPulls) {
  // The cap is clipped at 0, so friction acts only until spring and dashpot cancel, when the speed is that of the
  // clipped law: J_t = mu m_eff v (1 + e_clipped), though the pulling end goes on to slow the normal motion.
  const double zeta = 0.3, s = std::sqrt(1 - zeta * zeta), mu = 0.3;
  const double clipped = std::exp(-zeta / s * (pi - std::atan2(2 * zeta * s, 1 - 2 * zeta * zeta)));
  Packing probe = box(1, 1);
  add(probe, Disk{{}, 8.2e-3, pom});
  add(probe, Disk{{}, 5.25e-3, hdpe});
  const double m = reduced(mass(probe, 0), mass(probe, 1)), k = reduced(k_pom, k_hdpe);
  for (const bool attractive : {true, false}) {
    dem::ContactParameters law;
    law.friction_law = dem::RegularisedCoulomb{};
    law.friction = mu;
    law.normal_damping = 2 * zeta * std::sqrt(k * m);
    law.sliding_viscosity = 200;
    law.attractive_dashpot = attractive;
    const Oblique o = run(14 * mu * normal_speed, law);
    // Onset of the dashpot within one step: 2 zeta omega dt.
    EXPECT_NEAR(o.tangential_impulse(), mu * m * normal_speed * (1 + clipped),
                mu * m * normal_speed * 2 * zeta * pi / 4000 * 2)
        << (attractive ? "attractive dashpot kept" : "clipped");
  }
}

TEST(ObliqueCollision, AStiffViscosityWithinTheConeTakesTheWholeSlidingVelocityAway) {
  // No slip at the end: J_t = v_s/(1/m_eff + r_a^2/I_a + r_b^2/I_b) = m_eff v_s/3 for disks.
  dem::ContactParameters law;
  law.friction_law = dem::RegularisedCoulomb{};
  law.friction = 50;
  law.restitution = 1;
  law.normal_damping = 0;
  const double v_s = 4e-4;
  Packing probe = box(1, 1);
  add(probe, Disk{{}, 8.2e-3, pom});
  add(probe, Disk{{}, 5.25e-3, hdpe});
  const double m = reduced(mass(probe, 0), mass(probe, 1)), k = reduced(k_pom, k_hdpe);
  law.sliding_viscosity = 10 * m / (3 * contact_time(m, k));  // e^-10 of the sliding is left
  const Oblique o = run(v_s, law);
  EXPECT_NEAR(o.tangential_impulse(), m * v_s / 3, 2e-3 * m * v_s / 3);
}

TEST(ObliqueCollision, WithoutFrictionNothingTurns) {
  const Oblique o = run(4 * normal_speed, frictionless(0.4), 11, -7);
  EXPECT_EQ(o.after.grains.omega[0], 11);
  EXPECT_EQ(o.after.grains.omega[1], -7);
  EXPECT_NEAR(o.tangential_impulse(), 0, 1e-4 * o.normal_impulse());  // the line of centres turns a little
}

}  // namespace
}  // namespace arenite::verification
