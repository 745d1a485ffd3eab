#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grains/dem/engine.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

/// A block of equal disks that touch on a triangular lattice, periodic both ways: every disk has six contacts.
Packing triangular(int columns, int rows) {
  const double d = 0.01, pitch = d * (1 - 1e-4);
  Packing p = testing::empty_container(columns * pitch, rows * pitch * std::sqrt(0.75));
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      testing::add_grain(p, (c + 0.25 + 0.5 * (r % 2)) * pitch, (r + 0.5) * pitch * std::sqrt(0.75), 0.5 * d);
  return p;
}

IntegrationParameters with_step(IntegratorKind kind, double step) {
  IntegrationParameters integration;
  integration.integrator = kind;
  integration.time_step = step;
  return integration;
}

class Bounds : public ::testing::TestWithParam<IntegratorKind> {};

TEST_P(Bounds, ALatticeJustBelowTheBoundLosesItsMotionAndDoesNotGainAny) {
  Packing p = triangular(8, 8);
  RandomStream random(3, Purpose::test);
  for (std::size_t k = 0; k < p.grains.size(); ++k) {
    p.grains.velocity[k] = {random.uniform(-1e-4, 1e-4), random.uniform(-1e-4, 1e-4)};
    p.grains.omega[k] = random.uniform(-0.02, 0.02);
  }
  ContactParameters contact;
  contact.friction_law = dem::RegularisedCoulomb{};
  contact.restitution = 0.1;
  contact.attractive_dashpot = true;
  contact.friction = 1e6;  // never slides: the dashpots are all there is
  const StepBounds bounds = step_bounds(Engine(p, contact, with_step(GetParam(), 1e-9)));
  Engine engine(p, contact, with_step(GetParam(), 0.999 * bounds.largest()));
  const double start = energies_of(engine).kinetic;
  double highest = 0;
  for (int n = 0; n < 200; ++n) {
    engine.advance(1);
    highest = std::max(highest, energies_of(engine).kinetic);
  }
  EXPECT_LT(highest, 1.5 * start);
  EXPECT_LT(energies_of(engine).kinetic, 1e-2 * start);
}

INSTANTIATE_TEST_SUITE_P(All, Bounds,
                         ::testing::Values(IntegratorKind::velocity_verlet, IntegratorKind::leapfrog,
                                           IntegratorKind::gear5));

TEST(DampingBound, CountsTheTurningOfALattice) {
  // All disks turning alike is damped at 2 z gamma_s r^2/I = 24 gamma_s/m.
  const Packing p = triangular(8, 8);
  ContactParameters contact;
  contact.friction_law = dem::RegularisedCoulomb{};
  contact.sliding_viscosity = 10000;
  contact.normal_damping = 1;
  const double m = 1410 * std::numbers::pi * 0.25e-4 * 0.06, rate = 24 * 10000 / m;
  const double gear = step_bounds(Engine(p, contact, with_step(IntegratorKind::gear5, 1e-10))).damping;
  EXPECT_LT(gear, 0.164 / rate);
  EXPECT_GT(gear, 0.8 * 0.164 / rate);
}

}  // namespace
}  // namespace arenite::dem
