// The contact laws and the pair loop's equations know no dimension: two spheres that collide obliquely in space, by an explicit Verlet step around
// them, against closed forms. Contacts are so stiff that they do not turn while they last.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/dem/coefficients.hpp"
#include "grains/dem/kernels/pair_loop.hpp"
#include "grains/dem/laws/laws.hpp"

namespace arenite::verification {
namespace {

using namespace dem;

struct Sphere {
  double mass, radius;
  Vec3 place, velocity, spin;  ///< spin in rad/s; velocities are those of the middle of the step
  Vec3 seen, seen_spin;        ///< by forces
  double inertia() const { return 0.4 * mass * radius * radius; }
  GrainRecord<3> record() const { return {place, seen, seen_spin, radius, mass}; }
};

Vec3 numbers(Vec<3, Pack<1>> a) {
  return by_axis<3>([&](int axis) { return a[axis].raw[0]; });
}

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
    using V = Pack<1>;
    const V zero(0.0), damping(dem::damping_ratio(restitution, false) * std::sqrt(reduced_mass() * k));
    ContactMemory<V, Vec<3, V>> memory;
    for (Sphere* s : {&a, &b}) s->seen = s->velocity, s->seen_spin = s->spin;
    for (bool touching = true; touching;) {
      const GrainRecord<3> record[] = {a.record(), b.record()};
      const std::int32_t first = 0, second = 1;
      const PairPack<1, 3> pair(GrainPack<1, 3>(record, &first), GrainPack<1, 3>(record, &second), 0.5);
      Vec3 force, torque_a, torque_b;
      touching = pair.overlap.raw[0] > 0 || pair.approach.raw[0] > 0;
      if (pair.overlap.raw[0] > 0) {
        const ContactState<V, Vec<3, V>> state{pair.overlap, pair.approach, pair.sliding, pair.curvature, V(k), damping, V(viscosity), zero, V(friction), zero};
        const auto f = contact_force(laws, normal, NoAdhesion{}, friction_law, state, memory);
        const Vec<3, V> tangential = pair.without_twist(f.tangential);
        force = numbers(pair.force(f.normal, tangential));
        torque_a = numbers(pair.torque(pair.arm_i, tangential));
        torque_b = numbers(pair.torque(pair.arm_j, tangential));
      }
      step(a, force, torque_a, dt);
      step(b, -force, torque_b, dt);
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
