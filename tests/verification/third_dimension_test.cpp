// The contact laws know no dimension: two spheres that collide obliquely in space, by an explicit Verlet step around contact_force, against
// closed forms. Contacts are so stiff that they do not turn while they last.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/dem/coefficients.hpp"
#include "grains/dem/laws/laws.hpp"

namespace arenite::verification {
namespace {

using namespace dem;

struct Sphere {
  double mass, radius;
  Vec3 place, velocity, spin;  ///< spin in rad/s; velocities are those of the middle of the step
  Vec3 seen, seen_spin;        ///< by forces
  double inertia() const { return 0.4 * mass * radius * radius; }
};

/// How two spheres meet: touching in the direction n, with the relative velocity of a towards b.
struct Collision {
  Sphere a{0.03, 0.010, {}, {}, {}, {}, {}}, b{0.05, 0.013, {0.2, -0.1, 0.4}, {0.3, 0.1, -0.2}, {2, -1, 3}, {}, {}};
  Vec3 n{1.0 / 3, 2.0 / 3, 2.0 / 3}, t{2.0 / 3, 1.0 / 3, -2.0 / 3};
  double speed_n = 1, speed_t = 3;  ///< of approach, and of the touching points along t
  double stiffness = 1e12, restitution = 1, friction = 0.2, viscosity = 0;
  ContactLaws laws;

  double reduced_mass() const { return a.mass * b.mass / (a.mass + b.mass); }
  double contact_time() const { return std::numbers::pi * std::sqrt(reduced_mass() / stiffness); }
  /// Velocity of the touching point of a past that of b.
  Vec3 sliding() const { return a.velocity - b.velocity - cross(a.radius * a.spin + b.radius * b.spin, n); }
  Vec3 momentum() const { return a.mass * a.velocity + b.mass * b.velocity; }
  Vec3 angular_momentum() const {
    return a.mass * cross(a.place, a.velocity) + b.mass * cross(b.place, b.velocity) + a.inertia() * a.spin + b.inertia() * b.spin;
  }
  double energy() const {
    const auto of = [](const Sphere& s) { return 0.5 * s.mass * dot(s.velocity, s.velocity) + 0.5 * s.inertia() * dot(s.spin, s.spin); };
    return of(a) + of(b);
  }

  void approach() {
    a.spin = (1 / a.radius) * (-b.radius * b.spin);  // the touching points do not turn past each other yet
    a.velocity = b.velocity - speed_n * n + speed_t * t;
    a.place = b.place + (a.radius + b.radius) * n;
  }

  template <class N, class F> void run(const N& normal, const F& friction_law) {
    const double dt = contact_time() / 20000, k = stiffness;
    laws.lead = laws.lag = 0.5 * dt;
    ContactState<double, Vec3> c{};
    c.stiffness = k;
    c.damping = dem::damping_ratio(restitution, false) * std::sqrt(reduced_mass() * k);
    c.viscosity = viscosity;
    c.friction = friction;
    c.curvature = 1 / a.radius + 1 / b.radius;
    ContactMemory<double, Vec3> memory;
    for (Sphere* s : {&a, &b}) s->seen = s->velocity, s->seen_spin = s->spin;
    for (bool touching = true; touching;) {
      Vec3 d = a.place - b.place;
      const double distance = norm(d);
      const Vec3 normal_now = d / distance;
      c.overlap = a.radius + b.radius - distance;
      const double arm_a = a.radius - 0.5 * c.overlap, arm_b = b.radius - 0.5 * c.overlap;
      const Vec3 u = a.seen - b.seen - cross(arm_a * a.seen_spin + arm_b * b.seen_spin, normal_now);
      c.approach = -dot(u, normal_now);
      c.sliding = u - dot(u, normal_now) * normal_now;
      Vec3 force, tangential;
      touching = c.overlap > 0 || c.approach > 0;
      if (c.overlap > 0) {
        const auto f = contact_force(laws, normal, NoAdhesion{}, friction_law, c, memory);
        tangential = f.tangential - dot(f.tangential, normal_now) * normal_now;
        force = f.normal * normal_now + tangential;
      }
      const Vec3 torque = cross(normal_now, tangential);
      step(a, force, -arm_a * torque, dt);
      step(b, -force, -arm_b * torque, dt);
    }
  }
  static void step(Sphere& s, Vec3 force, Vec3 torque, double dt) {
    const Vec3 acceleration = force / s.mass, turning = torque / s.inertia();
    s.velocity += dt * acceleration;
    s.spin += dt * turning;
    s.place += dt * s.velocity;
    s.seen = s.velocity + 0.5 * dt * acceleration;
    s.seen_spin = s.spin + 0.5 * dt * turning;
  }
};

void expect_near(Vec3 a, Vec3 b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

/// Momentum and angular momentum are kept to rounding, whatever the laws are: forces are opposite and meet in one point.
template <class N, class F> void collide(Collision& c, const N& normal, const F& friction) {
  c.approach();
  const Vec3 momentum = c.momentum(), angular = c.angular_momentum();
  c.run(normal, friction);
  expect_near(c.momentum(), momentum, 1e-10 * norm(momentum));
  expect_near(c.angular_momentum(), angular, 1e-10 * norm(angular));
}

TEST(ThirdDimension, SpheresSeparateWithTheRestitutionAskedFor) {
  for (const double e : {1.0, 0.8, 0.4}) {
    Collision c;
    c.restitution = e;
    c.speed_t = 1;
    collide(c, Linear{}, NoFriction{});
    EXPECT_NEAR(dot(c.a.velocity - c.b.velocity, c.n), e * c.speed_n, 1e-3) << e;
    EXPECT_NEAR(dot(c.a.velocity - c.b.velocity, c.t), c.speed_t, 1e-3) << e;
  }
}

TEST(ThirdDimension, ASphereThatSlidesAllTheTimeGetsMuTimesTheNormalImpulse) {
  const auto check = [](auto friction, double viscosity) {
    Collision c;
    c.restitution = 0.8;
    c.laws.stiffness_ratio = 0.8;
    c.viscosity = viscosity;
    c.approach();
    const double before = c.energy();
    const Vec3 spin = c.a.spin;
    collide(c, Linear{}, friction);
    const double m = c.reduced_mass(), along = m * (1 + c.restitution) * c.speed_n, across = c.friction * along;
    const double left = c.speed_t - 3.5 * across / m;  // 1/m and r^2/I = 5/(2 m) of both
    expect_near(c.sliding(), left * c.t + c.restitution * c.speed_n * c.n, 2e-3);
    expect_near(c.a.spin - spin, (c.a.radius * across / c.a.inertia()) * cross(c.n, c.t), 1e-3 * c.a.radius * across / c.a.inertia());
    const double lost = 0.5 * m * c.speed_n * c.speed_n * (1 - c.restitution * c.restitution) + 0.5 * across * (c.speed_t + left);
    EXPECT_NEAR(before - c.energy(), lost, 1e-3 * lost);
  };
  check(RegularisedCoulomb{}, 1e9);
  check(CundallStrack{}, 0);
}

/// A tangential spring of 2/7 of the normal one swings as fast as that, and gives the touching points' velocity back: a superball.
TEST(ThirdDimension, ASpringOfTwoSeventhsTurnsTheSlidingRound) {
  Collision c;
  c.friction = 1e9;
  c.laws.stiffness_ratio = 2.0 / 7.0;
  c.approach();
  const double before = c.energy();
  collide(c, Linear{}, CundallStrack{});
  expect_near(c.sliding(), c.speed_n * c.n - c.speed_t * c.t, 3e-3);
  EXPECT_NEAR(c.energy(), before, 1e-4 * before);
}

}  // namespace
}  // namespace arenite::verification
