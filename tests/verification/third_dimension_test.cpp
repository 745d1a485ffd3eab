// Spheres that collide obliquely, are listed and fall, by the engine of disks, against closed forms. Where they
// collide, contacts are so stiff that they do not turn while they last.
#include "core/error.hpp"
#include "grains/dem/kernels/make_kernel.hpp"
#include "spheres.hpp"

namespace arenite::verification {

constinit const KernelIn<3> sphere_kernel = make_kernel<2, 3>("portable");

namespace {

TEST(ThirdDimension, SpheresSeparateWithTheRestitutionAskedFor) {
  for (const double e : {1.0, 0.8, 0.4})
    for (const auto scheme : {IntegratorKind::velocity_verlet, IntegratorKind::leapfrog, IntegratorKind::gear5}) {
      Collision c;
      c.integration.integrator = scheme;
      c.contact.restitution = e;
      c.speed_t = 1;
      c.collide();
      EXPECT_NEAR(dot(c.past(), c.n), e * c.speed_n, 1e-3) << e;
      EXPECT_NEAR(dot(c.past(), c.t), c.speed_t, 1e-3) << e;
      const double lost = 0.5 * c.reduced_mass() * c.speed_n * c.speed_n * (1 - e * e);
      EXPECT_NEAR(c.lost(), lost, 1e-3 * c.energy_before.kinetic) << e;
    }
}

TEST(ThirdDimension, ASphereThatSlidesAllTheTimeGetsMuTimesTheNormalImpulse) {
  const auto check = [](FrictionLaw law, double viscosity) {
    Collision c;
    c.contact.restitution = 0.8;
    c.contact.friction_law = law;
    c.contact.sliding_viscosity = viscosity;
    c.collide();
    const double m = c.reduced_mass(), along = m * 1.8 * c.speed_n, across = c.contact.friction * along;
    const double left = c.speed_t - 3.5 * across / m;  // 1/m and r^2/I = 5/(2 m) of both
    expect_near(c.sliding(), left * c.t + 0.8 * c.speed_n * c.n, 2e-3);
    const double turned = c.end.radius[0] * across / c.inertia(0);
    expect_near(c.end.omega[0] - c.start.grains.omega[0], turned * cross(c.n, c.t), 1e-3 * turned);
    const double lost = 0.5 * m * c.speed_n * c.speed_n * (1 - 0.8 * 0.8) + 0.5 * across * (c.speed_t + left);
    EXPECT_NEAR(c.lost(), lost, 1e-3 * lost);
  };
  check(RegularisedCoulomb{}, 1e5);
  check(CundallStrack{}, 0);
}

/// A tangential spring of 2/7 of the normal one swings as fast as that, and gives the touching points' velocity back: a
/// superball.
TEST(ThirdDimension, ASpringOfTwoSeventhsTurnsTheSlidingRound) {
  Collision c;
  c.contact.restitution = 1;
  c.contact.friction_law = CundallStrack{};
  c.contact.friction = 1e9;
  c.contact.tangential_stiffness_ratio = 2.0 / 7.0;
  c.collide();
  expect_near(c.sliding(), c.speed_n * c.n - c.speed_t * c.t, 3e-3);
  EXPECT_NEAR(c.lost(), 0, 1e-4 * c.energy_before.kinetic);
}

/// Over a corner of a periodic cell a pair is a disk and the image of another, and all is as in the middle.
TEST(ThirdDimension, SpheresCollideOverTheCornerOfAPeriodicCell) {
  Collision middle, corner;
  for (Collision* c : {&middle, &corner}) {
    c->contact.friction_law = CundallStrack{};
    c->start.domain.periodic = {true, true, true};
    c->approach(c == &middle ? Vec3{0.05, 0.045, 0.06} : Vec3{0.095, 0.093, 0.098});
    Vec3& place = c->start.grains.position[0];
    place = c->start.domain.wrapped(place);
    c->integration.time_step = c->contact_time() / 2000;
    SampleIn<3> s = c->sample();
    EXPECT_EQ(s.list.pairs, 1U);
    advance(s, ThreadPool(), 3000);
    c->end = packing_of(s).grains;
  }
  EXPECT_GT(dot(middle.past(), middle.n), 0);
  for (std::size_t k = 0; k < 2; ++k) {
    expect_near(corner.end.velocity[k], middle.end.velocity[k], 1e-6);
    expect_near(corner.end.omega[k], middle.end.omega[k], 1e-3);
  }
}

/// The list has every pair nearer than the skin, each once, those over the sides of the cell as well.
TEST(ThirdDimension, TheListHasThePairsThatAreNear) {
  for (const bool periodic : {false, true}) {
    Spheres box(1e6);
    box.start.domain.periodic = {periodic, false, periodic};
    const auto share = [](int k, double by) { return std::fmod(k * by, 1.0); };
    for (int k = 0; k < 400; ++k)
      box.add(0.003 + 0.002 * share(k, 0.37), 0.1 * Vec3{share(k, 0.7548), share(k, 0.5698), share(k, 0.4302)});
    const SampleIn<3> s = box.sample();
    std::size_t near = 0;
    for (std::size_t i = 0; i < 400; ++i)
      for (std::size_t j = 0; j < i; ++j)
        near += norm(s.domain.nearest_image(s.record[i].place - s.record[j].place)) <
                s.record[i].radius + s.record[j].radius + s.skin;
    EXPECT_EQ(s.list.pairs, near);
    EXPECT_GT(near, 400U);
  }
}

/// Without contacts: a parabola, and a turn at constant spin.
TEST(ThirdDimension, SpheresFallAndTurnByEveryStep) {
  for (const auto scheme : {IntegratorKind::velocity_verlet, IntegratorKind::leapfrog, IntegratorKind::gear5}) {
    const Vec3 g{0.5, -9.81, 3}, place{0.05, 0.08, 0.03}, velocity{0.1, 0.2, -0.1}, omega{2, -1, 3};
    Spheres box(1e3);
    box.add(0.01, place, velocity, omega);
    box.integration.time_step = 1e-4;
    box.integration.integrator = scheme;
    SampleIn<3> s = box.sample();
    s.gravity = g;
    advance(s, ThreadPool(), 500);
    const double time = 0.05;
    const GrainsIn<3> end = packing_of(s).grains;
    expect_near(end.position[0], place + time * velocity + 0.5 * time * time * g, 1e-13);
    expect_near(end.velocity[0], velocity + time * g, 1e-12);
    expect_near(end.angle[0], time * omega, 1e-13);
  }
}

/// A gas of elastic spheres in a periodic cell: momentum and energy stay, lists are built anew, and threads give the
/// same bits. A quarter of the usual step leaves a sixteenth of the error of the energy, some 2e-3 with that.
TEST(ThirdDimension, AGasOfSpheresKeepsMomentumAndEnergy) {
  Spheres box(1e5);
  box.start.domain.periodic = {true, true, true};
  box.contact.restitution = 1;
  const auto share = [](int k, double by) { return std::fmod(k * by, 1.0) - 0.5; };
  for (int k = 0; k < 125; ++k)
    box.add(0.008, 0.02 * Vec3{k % 5 + 0.5, k / 5 % 5 + 0.5, k / 25 + 0.5},
            Vec3{share(k, 0.7548), share(k, 0.5698), share(k, 0.4302)});
  box.integration.time_step = 0.25 * box.sample().dt;
  SampleIn<3> s = box.sample(), other = s;
  const auto momentum = [](const SampleIn<3>& of) {
    Vec3 sum;
    for (std::size_t k = 0; k < of.count; ++k) sum += of.record[k].mass * of.velocity[k];
    return sum;
  };
  const Vec3 momentum_before = momentum(s);
  const double before = energies_of(s).kinetic;
  advance(s, ThreadPool(1), 16'000);
  advance(other, ThreadPool(2), 16'000);
  const Energies after = energies_of(s);
  EXPECT_GT(s.builds, 5);
  EXPECT_GT(after.elastic, 0);
  EXPECT_NEAR(after.kinetic + after.elastic, before, 2e-4 * before);
  expect_near(momentum(s), momentum_before, 1e-12);
  for (std::size_t k = 0; k < s.count; ++k) EXPECT_EQ(s.record[k].place, other.record[k].place);
}

TEST(ThirdDimension, WhatIsOfThePlaneIsRefused) {
  Spheres box;
  box.add(0.01, {0.05, 0.05, 0.05});
  EXPECT_NO_THROW(box.sample());
  box.start.contacts.add(0, wall_partner(left), {1, 0, 0}, 1, {}, 0.01, 0);
  EXPECT_THROW(box.sample(), InputError);
}

}  // namespace
}  // namespace arenite::verification
