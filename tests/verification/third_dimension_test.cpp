// The loop over pairs, the gathering of its forces and the step of Verlet are those of disks, instantiated in space: two spheres that collide obliquely,
// against closed forms. Contacts are so stiff that they do not turn while they last, but for the test of that.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/dem/forces.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/kernels/pair_loop.hpp"

namespace arenite::verification {
namespace {

using namespace dem;

constexpr int W = 2;  // of the portable kernel

/// A vector of two spheres, one array a component.
struct Column {
  double along[3][2] = {};
  Vec3 operator[](int k) const { return {along[0][k], along[1][k], along[2][k]}; }
  void put(int k, Vec3 v) {
    for (int axis = 0; axis < 3; ++axis) along[axis][k] = v[axis];
  }
  std::array<double*, 3> task() { return {along[0], along[1], along[2]}; }
};

/// How two spheres meet: touching in the direction n, with the relative velocity of a, 0, towards b, 1.
struct Collision {
  GrainRecord<3> record[2];
  Column velocity, spin, angle;  ///< m/s, rad/s; of the middle of the step
  Vec3 n{1.0 / 3, 2.0 / 3, 2.0 / 3}, t{2.0 / 3, 1.0 / 3, -2.0 / 3};
  double speed_n = 1, speed_t = 3;  ///< of approach, and of the touching points along t
  double stiffness = 1e12, restitution = 1, friction = 0.2, viscosity = 0;
  ContactLaws laws;

  double reduced_mass() const { return record[0].mass * record[1].mass / (record[0].mass + record[1].mass); }
  double contact_time() const { return std::numbers::pi * std::sqrt(reduced_mass() / stiffness); }
  Vec3 past() const { return velocity[0] - velocity[1]; }
  /// Velocity of the touching point of a past that of b.
  Vec3 sliding() const { return past() - cross(record[0].radius * spin[0] + record[1].radius * spin[1], n); }
  /// Of both spheres.
  template <class Of> auto sum(const Of& of) const { return of(0) + of(1); }
  Vec3 momentum() const {
    return sum([&](int k) { return record[k].mass * velocity[k]; });
  }
  Vec3 angular_momentum() const {
    return sum([&](int k) { return record[k].mass * cross(record[k].place, velocity[k]) + inertia(record[k]) * spin[k]; });
  }
  double energy() const {
    return sum([&](int k) { return 0.5 * record[k].mass * dot(velocity[k], velocity[k]) + 0.5 * inertia(record[k]) * dot(spin[k], spin[k]); });
  }

  void approach() {
    record[0].mass = 0.03, record[0].radius = 0.010;
    record[1].mass = 0.05, record[1].radius = 0.013;
    spin.put(1, {2, -1, 3});
    spin.put(0, (1 / record[0].radius) * (-record[1].radius * spin[1]));  // the touching points do not turn past each other yet
    velocity.put(1, {0.3, 0.1, -0.2});
    velocity.put(0, velocity[1] - speed_n * n + speed_t * t);
    record[1].place = {0.2, -0.1, 0.4};
    record[0].place = record[1].place + (record[0].radius + record[1].radius) * n;
    for (int k = 0; k < 2; ++k) record[k].velocity = velocity[k], record[k].omega = spin[k];
  }

  // The one slot, behind it the one whose force stays 0; sphere 0 is its i, and 1 takes the reaction.
  SlotForce<3> force[2];
  double damping = 0, strength = 0, shear = 0;
  Column memory, acceleration, alpha, higher[6];
  const std::int32_t i = 0, j = 1, first[5] = {0, 4, 8, 12, 16}, group[16] = {0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1};

  template <class N, class F> void find_force() {
    laws.normal = N{};
    laws.friction = F{};
    const PairTask<3> task{record, &i, &j, &stiffness, &damping, &viscosity, &strength, &shear, memory.task(), nullptr, force, friction, 0, 0.5};
    pair_loop<W, 3, N, NoAdhesion, F>(task, laws, 0, 1);
  }
  template <IntegratorKind scheme> void make_step(double dt, Vec3 gravity = {}) {
    SweepTask<3> task{};
    task.record = record;
    task.slots = {force, group, first};
    task.velocity = velocity.task(), task.acceleration = acceleration.task();
    task.omega = spin.task(), task.angle = angle.task(), task.alpha = alpha.task();
    task.listed = {acceleration.along[0], acceleration.along[1], acceleration.along[2]};
    for (int coordinate = 0; coordinate < 6; ++coordinate) task.higher[coordinate] = higher[coordinate].task();
    task.gravity = gravity;
    task.dt = task.kick = dt;
    task.ahead = 0.5 * dt;
    task.turning = 1;
    sweep<W, 3, scheme>(task, 0, 2);
  }
  template <class N, class F> void run() {
    const double dt = contact_time() / 20000;
    laws.lead = laws.lag = 0.5 * dt;
    damping = dem::damping_ratio(restitution, false) * std::sqrt(reduced_mass() * stiffness);
    do {
      find_force<N, F>();
      make_step<IntegratorKind::velocity_verlet>(dt);
    } while (pair_kinematics(record[0], record[1], Arms::contact_point).overlap > 0 || dot(past(), n) < 0);
  }
};

void expect_near(Vec3 a, Vec3 b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

/// Momentum and angular momentum are kept to rounding, whatever the laws are: forces are opposite and meet in one point.
template <class N, class F> void collide(Collision& c) {
  c.approach();
  const Vec3 momentum = c.momentum(), angular = c.angular_momentum();
  c.run<N, F>();
  expect_near(c.momentum(), momentum, 1e-10 * norm(momentum));
  expect_near(c.angular_momentum(), angular, 1e-10 * norm(angular));
}

TEST(ThirdDimension, SpheresSeparateWithTheRestitutionAskedFor) {
  for (const double e : {1.0, 0.8, 0.4}) {
    Collision c;
    c.restitution = e;
    c.speed_t = 1;
    collide<Linear, NoFriction>(c);
    EXPECT_NEAR(dot(c.past(), c.n), e * c.speed_n, 1e-3) << e;
    EXPECT_NEAR(dot(c.past(), c.t), c.speed_t, 1e-3) << e;
  }
}

TEST(ThirdDimension, ASphereThatSlidesAllTheTimeGetsMuTimesTheNormalImpulse) {
  const auto check = []<class F>(F, double viscosity) {
    Collision c;
    c.restitution = 0.8;
    c.laws.stiffness_ratio = 0.8;
    c.viscosity = viscosity;
    c.approach();
    const double before = c.energy();
    const Vec3 spin = c.spin[0];
    collide<Linear, F>(c);
    const double m = c.reduced_mass(), along = m * (1 + c.restitution) * c.speed_n, across = c.friction * along;
    const double left = c.speed_t - 3.5 * across / m;  // 1/m and r^2/I = 5/(2 m) of both
    expect_near(c.sliding(), left * c.t + c.restitution * c.speed_n * c.n, 2e-3);
    const double turned = c.record[0].radius * across / inertia(c.record[0]);
    expect_near(c.spin[0] - spin, turned * cross(c.n, c.t), 1e-3 * turned);
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
  collide<Linear, CundallStrack>(c);
  expect_near(c.sliding(), c.speed_n * c.n - c.speed_t * c.t, 3e-3);
  EXPECT_NEAR(c.energy(), before, 1e-4 * before);
}

/// A pair that turns as one body slides nowhere, and the force of its spring turns with it.
TEST(ThirdDimension, ASpringGoesAlongWithAContactThatTurns) {
  Collision c;
  c.approach();
  c.friction = 1e9;
  c.laws.stiffness_ratio = 0.5;
  const Vec3 axis = c.t, aside = cross(axis, c.n), middle = c.record[1].place;  // axis, n and aside are at right angles
  const double distance = 0.999 * (c.record[0].radius + c.record[1].radius), along = 1e-5, across = 2e-5;
  c.memory.put(0, along * axis + across * aside);
  const double kt = 0.5 * c.stiffness, turn = 1.5;
  constexpr int steps = 3000;
  for (int step = 0; step <= steps; ++step) {
    const double angle = turn * step / steps;
    c.record[0].place = middle + distance * (std::cos(angle) * c.n + std::sin(angle) * aside);
    for (auto& sphere : c.record) sphere.velocity = sphere.omega = {};
    c.find_force<Linear, CundallStrack>();
  }
  const Vec3 n = std::cos(turn) * c.n + std::sin(turn) * aside, sideways = std::cos(turn) * aside - std::sin(turn) * c.n;
  const Vec3 tangential = c.force[0].on_i - dot(c.force[0].on_i, n) * n;
  expect_near(tangential, -kt * cross(along * axis + across * sideways, n), 5e-4 * kt * across);  // laid down step by step, of first order in its turn
  expect_near(c.force[0].torque_i, (dot(c.force[0].torque_i, sideways)) * sideways + dot(c.force[0].torque_i, axis) * axis, 1e-12 * norm(c.force[0].torque_i));
}

/// Without contacts: a parabola, and a turn at constant spin.
TEST(ThirdDimension, SpheresFallAndTurnByEveryStep) {
  const auto fall = []<IntegratorKind scheme>(std::integral_constant<IntegratorKind, scheme>) {
    const Vec3 g{0.5, -9.81, 3};
    const double dt = 1e-3, time = 0.1;
    Collision c;
    c.approach();
    const Vec3 place = c.record[0].place, velocity = c.velocity[0], spin = c.spin[0];
    const bool corrects = integrator_of(scheme).corrects();
    for (int k = 0; k < 2; ++k) corrects ? c.acceleration.put(k, g) : c.velocity.put(k, c.velocity[k] - 0.5 * dt * g);
    for (int step = 0; step < 100; ++step) c.make_step<scheme>(dt, g);
    expect_near(c.record[0].place, place + time * velocity + 0.5 * time * time * g, 1e-13);
    expect_near(c.record[0].velocity, velocity + time * g, 1e-12);
    expect_near(c.angle[0], time * spin, 1e-13);
  };
  fall(std::integral_constant<IntegratorKind, IntegratorKind::velocity_verlet>());
  fall(std::integral_constant<IntegratorKind, IntegratorKind::gear5>());
}

}  // namespace
}  // namespace arenite::verification
