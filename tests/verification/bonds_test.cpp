#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;
using dem::IntegratorKind;

constexpr double radius = 5e-3, thickness = 0.06;

dem::ContactParameters cemented(const dem::ParallelBond& bond) {
  dem::ContactParameters contact = frictionless(1);
  contact.bonds = bond;
  return contact;
}

dem::ParallelBond unbreakable(double modulus, double damping = 0) {
  dem::ParallelBond bond;
  bond.modulus = modulus;
  bond.tensile_strength = bond.cohesion = 1e30;
  bond.damping = damping;
  return bond;
}

/// A row of touching disks from the left wall on.
Packing row(int disks) {
  Packing p = box(1, 1);
  for (int k = 0; k < disks; ++k) add(p, {{radius * (2 * k + 1), 0.5}, radius});
  return p;
}

/// A beam that the left wall holds, bent by its weight.
struct Sag {
  double tip, beam;
};
Sag sag_of_cantilever(int bonds, double stiffness_ratio) {
  dem::ParallelBond bond = unbreakable(1e9);
  bond.stiffness_ratio = stiffness_ratio;
  const Packing start = row(bonds + 1);
  const double length = 2 * radius, area = 2 * radius * thickness,
               shear = bond.modulus * area / length / stiffness_ratio;
  const double inertia = 2.0 / 3 * std::pow(radius, 3) * thickness, rigidity = bond.modulus * inertia;
  const double weight = mass(start, 0) * gravity, whole = length * bonds;

  Engine engine(start, cemented(bond), {});
  make_bonds(engine);
  set_rough(engine, {true, false, false, false});
  set_gravity(engine, {0, -gravity});
  const double slowest = 3.516 * std::sqrt(rigidity * length / mass(start, 0)) / (whole * whole);
  set_drag(engine, 2 * slowest);
  while (time_of(engine) < 40 / slowest) engine.advance(1000);

  // Timoshenko's beam under point loads at a: P a^2 (3 L - a)/(6 E I) + P a/(kappa G A), in which a bond that shears by
  // 1/k_s has its own bending, l^3/(12 E I).
  const double shear_compliance = (1 / shear - std::pow(length, 3) / (12 * rigidity)) / length;
  Sag sag{0.5 - packing_of(engine).grains.position[static_cast<std::size_t>(bonds)].y, 0};
  for (int m = 1; m <= bonds; ++m) {
    const double a = length * m;
    sag.beam += weight * (a * a * (3 * whole - a) / (6 * rigidity) + a * shear_compliance);
  }
  return sag;
}

TEST(Bonds, ChainSagsAsABeam) {
  for (const double ratio : {1.0, 2.5})
    for (const int bonds : {1, 10}) {
      const Sag sag = sag_of_cantilever(bonds, ratio);
      EXPECT_NEAR(sag.tip, sag.beam, 1e-5 * sag.beam) << bonds;
      EXPECT_LT(sag.tip, 1e-3 * radius * bonds);
    }
}

TEST(Bonds, TensionHoldsASpinningPair) {
  // Two equal disks about their middle: T = m omega^2 l/2.
  Packing p = box(1, 1);
  const double spin = 300;
  for (const double side : {-1.0, 1.0})
    add(p, {{0.5 + side * radius, 0.5}, radius, pom, {0, side * spin * radius}, spin});
  Engine engine(p, cemented(unbreakable(1e9, 0.2)), {});
  make_bonds(engine);
  const double before = angular_momentum(p, {0.5, 0.5});
  while (time_of(engine) < 0.05) engine.advance(100);  // more than two turns
  const Packing end = packing_of(engine);
  const double length = norm(end.grains.position[1] - end.grains.position[0]), turning = end.grains.omega[0];
  EXPECT_GT(end.grains.angle[0], 4 * pi);
  EXPECT_NEAR(end.grains.omega[1], turning, 1e-9 * turning);
  EXPECT_NEAR(-end.bonds[0].fn, 0.5 * mass(p, 0) * turning * turning * length, 1e-6 * std::abs(end.bonds[0].fn));
  EXPECT_NEAR(angular_momentum(end, {0.5, 0.5}), before, 1e-12 * before);
}

TEST(Bonds, HoldBeyondTheReachOfTheList) {
  // Walls that hold both grains pull them apart by a diameter.
  Packing p = box(0.02, 0.5);
  for (const double x : {0.005, 0.015}) add(p, {{x, 0.25}, radius});
  Engine engine(p, cemented(unbreakable(1e6)), {});
  make_bonds(engine);
  set_rough(engine, {true, true, false, false});
  set_drives(engine, {dem::WallDrive{}, {dem::WallDrive::Kind::velocity, 0.1}, {}, {}});
  while (time_of(engine) < 0.1) engine.advance(100);
  const double stretch = engine.domain.wall[right].position - 0.02;
  EXPECT_GT(stretch, 0.01);
  EXPECT_GT(engine.builds, 5);
  EXPECT_NEAR(packing_of(engine).bonds[0].fn, -1e6 * thickness * stretch, 1e-9 * 1e6 * thickness * stretch);
  EXPECT_NEAR(engine.domain.wall[right].force, -1e6 * thickness * stretch, 1e-9 * 1e6 * thickness * stretch);
}

/// A cemented block of a triangular lattice, its disks in motion.
Packing block(int columns, int rows, double speed) {
  Packing p = box(1, 1);
  RandomStream random(3, Purpose::test);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      add(p, {{0.4 + 2 * radius * (c + 0.5 * (r % 2)), 0.4 + 2 * radius * std::sqrt(0.75) * r},
              radius,
              pom,
              {random.uniform(-speed, speed), random.uniform(-speed, speed)},
              random.uniform(-speed, speed) / radius});
  return p;
}

TEST(Bonds, KeepMomentumAndAngularMomentum) {
  for (const double strength : {1e30, 1e6}) {
    const Packing p = block(6, 6, 1);
    dem::ParallelBond bond = unbreakable(2e9, 0.1);
    bond.tensile_strength = bond.cohesion = strength;
    bond.gap = 0.01;
    Engine engine(p, cemented(bond), {});
    make_bonds(engine);
    engine.advance(3000);
    const Packing end = packing_of(engine);
    const double scale = 36 * mass(p, 0) * 1;
    EXPECT_EQ(
        std::any_of(end.bonds.begin(), end.bonds.end(), [](const Bond& b) { return b.broken != BondBreak::none; }),
        strength < 1e10);
    EXPECT_LT(norm(momentum(end) - momentum(p)), 1e-12 * scale);
    EXPECT_NEAR(angular_momentum(end, {0.43, 0.43}), angular_momentum(p, {0.43, 0.43}), 1e-12 * scale * 0.06);
  }
}

struct PressBalance {
  double imbalance, work, broken, dashpots;
  std::size_t breaks;
};

/// Two walls close in on a cemented block that fills its box.
PressBalance press(const dem::ParallelBond& bond, IntegratorKind kind, double friction,
                   double share_of_contact_time = 500) {
  Packing start = shaken_lattice(7, 7, 1);
  dem::ContactParameters law;
  law.friction = friction;
  law.restitution = 0.5;
  law.bonds = bond;
  law.attractive_dashpot = true;
  dem::IntegrationParameters how = with_step(shortest_contact_time() / share_of_contact_time, kind);
  how.track_energy = true;
  Engine engine(start, law, how);
  make_bonds(engine);
  set_drives(engine, {dem::WallDrive{}, moved(-0.8), moved(1.1), dem::WallDrive{}});
  const Energies before = energies_of(engine);
  engine.advance(static_cast<std::int64_t>(30 * share_of_contact_time));
  const Energies after = energies_of(engine);
  const dem::BondCount count = count_bonds(engine);
  return {stored(after) - stored(before) + lost(after) - lost(before) - after.work_walls + before.work_walls,
          after.work_walls - before.work_walls, after.dissipated_breakage, after.dissipated_normal,
          count.made() - count.intact};
}

TEST(Bonds, EnergyIsClosedToAMillionthOfTheWorkAtAStepOfTcOver500) {
  for (const auto kind : integrators)
    for (const double damping : {0.0, 0.2}) {
      SCOPED_TRACE(name(kind));
      dem::ParallelBond bond = unbreakable(1e9, damping);
      bond.gap = 0.1;
      const PressBalance b = press(bond, kind, 0.5);
      EXPECT_GT(b.work, 0.1);
      EXPECT_EQ(b.broken, 0);
      EXPECT_LT(std::abs(b.imbalance), 1e-6 * b.work) << damping;
    }
}

TEST(Bonds, EnergyIsClosedWhereTheyBreak) {
  for (const auto kind : integrators) {
    SCOPED_TRACE(name(kind));
    dem::ParallelBond bond = unbreakable(1e9, 0.1);
    bond.gap = 0.1;
    bond.tensile_strength = bond.cohesion = 1e6;
    const PressBalance b = press(bond, kind, 0.5);
    EXPECT_GT(b.breaks, 10u);
    EXPECT_GT(b.broken, 1e-3 * b.work);
    EXPECT_LT(std::abs(b.imbalance), 1e-6 * b.work);
  }
}

}  // namespace
}  // namespace arenite::verification
