#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;
using dem::IntegratorKind;

struct Pair {
  const char* name;
  Disk a, b;
  double k;  ///< contact stiffness that the pair must have, N/m
};

/// Like and unlike sizes and materials; T's rule for the stiffness of unlike ones.
std::vector<Pair> pairs() {
  return {{"equal POM disks", {{}, 6.2e-3, pom}, {{}, 6.2e-3, pom}, k_pom},
          {"unequal POM disks", {{}, 3.1e-3, pom}, {{}, 15.45e-3, pom}, k_pom},
          {"POM on HDPE", {{}, 8.2e-3, pom}, {{}, 5.25e-3, hdpe}, reduced(k_pom, k_hdpe)}};
}

struct Outcome {
  double restitution = 0, duration = 0, deepest = 0, stiffest = 0;
};

/// Steps until a contact came and went.
Outcome collide(const Packing& start, const dem::ContactParameters& law, const dem::IntegrationParameters& how,
                double approach, const std::function<double(const Packing&)>& separation_speed) {
  Engine engine(start, law, how);
  Outcome out;
  int in_contact = 0;
  for (int step = 0; step < 400000; ++step) {
    engine.advance(1);
    const Packing now = packing_of(engine);
    if (now.contacts.size() == 0) {
      if (in_contact > 0) {
        out.restitution = separation_speed(now) / approach;
        out.duration = in_contact * engine.dt;
        return out;
      }
      continue;
    }
    ++in_contact;
    out.deepest = std::max(out.deepest, now.contacts.overlap[0]);
    out.stiffest = std::max(out.stiffest, now.contacts.fn[0]);
  }
  ADD_FAILURE() << "no collision came to its end";
  return out;
}

/// Two disks that meet along a slanted line of centres, the gap an odd fraction of a step's travel.
Packing head_on(const Pair& pair, double speed, double dt) {
  Packing p = box(1, 1);
  const Vec2 n{std::cos(0.7), std::sin(0.7)};
  const double distance = pair.a.radius + pair.b.radius + 3.37 * speed * dt;
  Disk a = pair.a, b = pair.b;
  a.centre = {0.5, 0.5};
  b.centre = a.centre + distance * n;
  a.velocity = 0.75 * speed * n;
  b.velocity = -0.25 * speed * n;
  add(p, a);
  add(p, b);
  return p;
}
double separation(const Packing& p) {
  const Vec2 n = p.grains.position[1] - p.grains.position[0];
  return dot(velocity(p, 1) - velocity(p, 0), (1 / norm(n)) * n);
}

// The dashpot's force jumps by alpha v where the contact begins and ends; one step's error in the time of such a jump
// changes the velocity by up to (alpha/m_eff) dt = 2 zeta omega dt of itself, and there are two. The spring adds
// (omega dt)^2. Leapfrog damps with the velocity of half a step ago, the same once more; Gear's predicted derivatives
// carry the jump on for a few steps: four times that.
double restitution_tolerance(double e, double omega_dt, IntegratorKind kind) {
  constexpr double factor[] = {1, 2, 4};
  const double jump = 4 * damping_ratio(e) * omega_dt + omega_dt * omega_dt;
  return e * jump * factor[static_cast<int>(kind)] + 1e-9;
}

TEST(Collision, RestitutionMeasuredIsTheOneAskedForAndTheContactLastsPiOverTheDampedFrequency) {
  for (const auto kind : integrators)
    for (const Pair& pair : pairs())
      for (const double e : {1.0, 0.9, 0.5, 0.1, 0.02}) {
        SCOPED_TRACE(std::string(name(kind)) + ", " + pair.name + ", e = " + std::to_string(e));
        Packing probe = head_on(pair, 1, 0);
        const double m = reduced(mass(probe, 0), mass(probe, 1));
        const double tc = contact_time(m, pair.k), dt = tc / 2000, omega_dt = pi / 2000;
        const Outcome out = collide(head_on(pair, 0.5, dt), frictionless(e), with_step(dt, kind), 0.5, separation);
        EXPECT_NEAR(out.restitution, e, restitution_tolerance(e, omega_dt, kind));
        const double zeta = damping_ratio(e);
        EXPECT_NEAR(out.duration, tc / std::sqrt(1 - zeta * zeta), 3 * dt);
      }
}

TEST(Collision, RestitutionOnAWallIsTheOneAskedForWithTheWholeMassAndTheStiffestMaterial) {
  for (const auto kind : integrators)
    for (const std::int32_t material : {pom, hdpe})
      for (const double e : {1.0, 0.6, 0.1})
        for (int side = 0; side < 4; ++side) {
          SCOPED_TRACE(std::string(name(kind)) + ", e = " + std::to_string(e) + ", " + side_names[side]);
          const double r = 5e-3, speed = 0.5;
          Packing p = box(0.1, 0.1);
          add(p, {{0.05, 0.05}, r, material});
          const double tc = contact_time(mass(p, 0), k_pom), dt = tc / 2000;
          const Vec2 n = inward_normal(side);
          const Vec2 centre = Vec2{0.05, 0.05} - (0.05 - r - 2.6 * speed * dt) * n;
          p.grains.position[0] = centre;
          p.grains.velocity[0] = {-speed * n.x, -speed * n.y};
          add(p, {{0.05, 0.05}, r, pom});  // out of the way; walls are as stiff as the stiffest grain of the sample
          const Outcome out = collide(p, frictionless(e), with_step(dt, kind), speed,
                                      [&](const Packing& now) { return dot(velocity(now, 0), n); });
          EXPECT_NEAR(out.restitution, e, restitution_tolerance(e, pi / 2000, kind));
          const double zeta = damping_ratio(e);
          EXPECT_NEAR(out.duration, tc / std::sqrt(1 - zeta * zeta), 3 * dt);
        }
}

TEST(Collision, DeepestOverlapAndForceOfAnElasticCollisionAreVOverOmegaAndKTimesIt) {
  for (const Pair& pair : pairs()) {
    SCOPED_TRACE(pair.name);
    Packing probe = head_on(pair, 1, 0);
    const double m = reduced(mass(probe, 0), mass(probe, 1));
    const double omega = std::sqrt(pair.k / m), dt = pi / omega / 1000, speed = 0.8;
    const Outcome out = collide(head_on(pair, speed, dt), frictionless(1), with_step(dt), speed, separation);
    // At its top the overlap is sampled within half a step: (omega dt/2)^2/2; the integrator adds its own (omega
    // dt)^2/8.
    EXPECT_NEAR(out.deepest, speed / omega, 1e-5 * speed / omega);
    EXPECT_NEAR(out.stiffest, pair.k * speed / omega, 1e-5 * pair.k * speed / omega);
  }
}

/// Restitution when the contact force is clipped at zero: the contact ends where spring and dashpot cancel
/// (Schwager and Poeschel, Granular Matter 9, 465, 2007).
double clipped_restitution(double zeta) {
  const double s = std::sqrt(1 - zeta * zeta);
  const double angle = zeta < std::sqrt(0.5) ? pi - std::atan2(2 * zeta * s, 1 - 2 * zeta * zeta)
                                             : std::atan2(2 * zeta * s, 2 * zeta * zeta - 1);
  return std::exp(-zeta / s * angle);
}

TEST(Collision, ClippingTheAttractiveDashpotRaisesTheRestitutionToItsOwnClosedForm) {
  const Pair pair = pairs()[2];
  Packing probe = head_on(pair, 1, 0);
  const double m = reduced(mass(probe, 0), mass(probe, 1));
  const double dt = contact_time(m, pair.k) / 4000;
  for (const double zeta : {0.1, 0.4, 0.6, 0.8}) {
    SCOPED_TRACE("zeta = " + std::to_string(zeta));
    dem::ContactParameters law = frictionless(0.5);
    law.normal_damping = 2 * zeta * std::sqrt(pair.k * m);
    const double omega_dt = pi / 4000, speed = 0.5;
    law.attractive_dashpot = false;
    const double clipped = collide(head_on(pair, speed, dt), law, with_step(dt), speed, separation).restitution;
    EXPECT_NEAR(clipped, clipped_restitution(zeta),
                clipped_restitution(zeta) * (2 * zeta * omega_dt + omega_dt * omega_dt));
    law.attractive_dashpot = true;
    const double kept = collide(head_on(pair, speed, dt), law, with_step(dt), speed, separation).restitution;
    const double e = std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta));
    EXPECT_NEAR(kept, e, e * (4 * zeta * omega_dt + omega_dt * omega_dt));
  }
}

TEST(Collision, HertzKeepsTheRestitutionAskedForAtEverySpeed) {
  for (const auto kind : integrators)
    for (const double e : {1.0, 0.8, 0.3})
      for (const double speed : {0.05, 1.0}) {
        SCOPED_TRACE(std::string(name(kind)) + ", e = " + std::to_string(e) + ", v = " + std::to_string(speed));
        const Pair pair = pairs()[0];
        Packing probe = head_on(pair, 1, 0);
        const double dt = contact_time(reduced(mass(probe, 0), mass(probe, 1)), pair.k) / 1000;
        dem::ContactParameters law = frictionless(e);
        law.normal = dem::Hertz{};
        const Outcome out = collide(head_on(pair, speed, dt), law, with_step(dt, kind), speed, separation);
        // The dashpot grows as h^(1/4), so it does not jump; a step's shift of the ends costs (dt/T)^(5/4).
        EXPECT_NEAR(out.restitution, e, 2e-3 * e);
      }
}

TEST(Collision, RestitutionIsTheOneAskedForWhereTheDashpotCannotPullEither) {
  // The dashpot's onset within one step costs 4 zeta omega dt, and zeta < 1/sqrt(e).
  for (const dem::NormalLaw& normal : std::initializer_list<dem::NormalLaw>{dem::Linear{}, dem::Hertz{}})
    for (const auto kind : integrators)
      for (const double e : {1.0, 0.9, 0.5, 0.1, 0.02}) {
        SCOPED_TRACE(std::string(name(kind)) + (normal == dem::Hertz{} ? ", Hertz" : "") +
                     ", e = " + std::to_string(e));
        const Pair pair = pairs()[2];
        Packing probe = head_on(pair, 1, 0);
        const double dt = contact_time(reduced(mass(probe, 0), mass(probe, 1)), pair.k) / 20000, omega_dt = pi / 20000;
        dem::ContactParameters law = frictionless(e);
        law.normal = normal;
        law.attractive_dashpot = false;
        const Outcome out = collide(head_on(pair, 0.5, dt), law, with_step(dt, kind), 0.5, separation);
        EXPECT_NEAR(out.restitution, e, 16 * std::sqrt(e) * omega_dt);
      }
}

TEST(Collision, HertzContactLastsTheClassicalTime) {
  const Pair pair = pairs()[1];
  Packing probe = head_on(pair, 1, 0);
  const double m = reduced(mass(probe, 0), mass(probe, 1)), speed = 0.4;
  const double dt = contact_time(m, pair.k) / 1000;
  dem::ContactParameters law = frictionless(1);
  law.normal = dem::Hertz{};
  const Outcome out = collide(head_on(pair, speed, dt), law, with_step(dt), speed, separation);
  const double k_hertz = out.stiffest / std::pow(out.deepest, 1.5);
  EXPECT_NEAR(out.deepest, std::pow(1.25 * m * speed * speed / k_hertz, 0.4), 1e-5 * out.deepest);
  EXPECT_NEAR(out.duration, 2.943275 * out.deepest / speed, 4 * dt);
}

}  // namespace
}  // namespace arenite::verification
