#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/dem/advance.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/setup.hpp"

// The engine of disks, instantiated in space: sample, list of neighbours, kernel, steps and walls are its own.
namespace arenite::verification {

using namespace dem;

extern const KernelIn<3> sphere_kernel;  ///< compiled with the first file of tests
inline constexpr int low_z = 4;          ///< the first of the third pair of sides

inline void expect_near(Vec3 a, Vec3 b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

/// A box of 0.1 m with its corner in the origin, and spheres of steel in it.
struct Spheres {
  PackingIn<3> start;
  ContactParameters contact;
  IntegrationParameters integration;

  explicit Spheres(double stiffness = 1e12) {
    start.materials = {{"steel", 7800, stiffness}};
    for (int side = 0; side < 6; ++side) start.domain.wall[side].position = side % 2 == 0 ? 0 : 0.1;
    contact.friction = 0.2;
    contact.friction_law = NoFriction{};
  }
  void add(double radius, Vec3 place, Vec3 velocity = {}, Vec3 omega = {}) {
    GrainsIn<3>& g = start.grains;
    g.resize(g.size() + 1);
    g.radius.back() = radius;
    g.position.back() = place;
    g.velocity.back() = velocity;
    g.omega.back() = omega;
  }
  double mass(std::size_t k) const { return 7800 * 4.0 / 3.0 * std::numbers::pi * std::pow(start.grains.radius[k], 3); }
  double inertia(std::size_t k) const { return 0.4 * mass(k) * std::pow(start.grains.radius[k], 2); }
  SampleIn<3> sample() const { return make_sample(start, contact, integration, sphere_kernel); }
};

/// How two spheres meet: touching in the direction n, with the relative velocity of the first towards the second.
struct Collision : Spheres {
  Vec3 n{1.0 / 3, 2.0 / 3, 2.0 / 3}, t{2.0 / 3, 1.0 / 3, -2.0 / 3};
  double speed_n = 1, speed_t = 3;  ///< of approach, and of the touching points along t
  GrainsIn<3> end;
  Energies energy_before, energy_after;

  double reduced_mass() const { return mass(0) * mass(1) / (mass(0) + mass(1)); }
  double contact_time() const { return std::numbers::pi * std::sqrt(reduced_mass() / start.materials[0].stiffness); }
  Vec3 past() const { return end.velocity[0] - end.velocity[1]; }
  /// Velocity of the touching point of the first past that of the second.
  Vec3 sliding() const { return past() - cross(end.radius[0] * end.omega[0] + end.radius[1] * end.omega[1], n); }
  Vec3 momentum(const GrainsIn<3>& g) const { return mass(0) * g.velocity[0] + mass(1) * g.velocity[1]; }
  Vec3 angular_momentum(const GrainsIn<3>& g) const {
    const auto of = [&](std::size_t k) {
      return mass(k) * cross(g.position[k], g.velocity[k]) + inertia(k) * g.omega[k];
    };
    return of(0) + of(1);
  }
  double lost() const { return energy_before.kinetic - energy_after.kinetic; }

  /// The touching points do not turn past each other at first. `second` is where the second sphere is.
  void approach(Vec3 second = {0.05, 0.045, 0.06}) {
    const Vec3 spin{2, -1, 3}, velocity{0.3, 0.1, -0.2};
    start.grains = {};
    add(0.010, second + 0.023 * n, velocity - speed_n * n + speed_t * t, -1.3 * spin);
    add(0.013, second, velocity, spin);
  }
  /// Momentum and angular momentum are kept to rounding, whatever the laws are: forces are opposite and meet in one
  /// point.
  void run() {
    integration.time_step = contact_time() / 20000;
    SampleIn<3> s = sample();
    energy_before = energies_of(s);
    const ThreadPool pool;
    const auto apart = [&] { return !(pair_kinematics(s.record[0], s.record[1], Arms::contact_point).overlap > 0); };
    do advance(s, pool, 50);
    while (!apart());
    const PackingIn<3> now = packing_of(s);
    end = now.grains;
    energy_after = energies_of(s);
    EXPECT_EQ(energy_after.elastic, 0);
    const double whole = norm(momentum(start.grains)), turning = norm(angular_momentum(start.grains));
    expect_near(momentum(end), momentum(start.grains), 1e-10 * whole);
    expect_near(angular_momentum(end), angular_momentum(start.grains), 1e-10 * turning);
  }
  void collide() {
    approach();
    run();
  }
};

}  // namespace arenite::verification
