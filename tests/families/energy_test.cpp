#include <gtest/gtest.h>

#include <cmath>

#include "grains/dem/engine.hpp"
#include "grains/dem/glue.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

struct Case {
  const char* name;
  IntegratorKind integrator;
  NormalLaw normal;
  FrictionLaw friction;
  Adhesion adhesion;
  bool periodic;
  double order;  ///< the balance closes at least at this order
};

struct Balance {
  double gap, throughput;
};

/// A crowd that starts with overlaps, is pushed by a servo wall and a moving one, falls, is dragged, has its gravity
/// and drives changed and its glue taken away on the road.
Balance run(const Case& c, double safety) {
  Packing p = testing::crowd(7, 7, 5, 0.0125);
  p.domain.periodic[0] = p.domain.periodic[1] = c.periodic;
  for (std::size_t k = 0; k < p.grains.size(); k += 2) p.grains.zone[k] = 1;
  ContactParameters contact;
  contact.normal = c.normal;
  contact.friction_law = c.friction;
  contact.restitution = 0.5;
  contact.adhesion = c.adhesion;
  contact.surface_energy = 1e5;
  IntegrationParameters integration;
  integration.integrator = c.integrator;
  integration.track_energy = true;
  integration.safety = safety;
  integration.drag = 20;
  Engine engine(p, contact, integration);
  const Energies before = energies_of(engine);
  WallDrives drives;
  drives[bottom] = {WallDrive::Kind::force, 3000};
  drives[right] = {WallDrive::Kind::velocity, -0.2};
  set_drives(engine, drives);
  set_gravity(engine, {0, -9.81});
  const auto half = static_cast<std::int64_t>(8 / safety);
  engine.advance(half);
  set_gravity(engine, {300, -5});
  set_glue(engine, false);
  drives[left] = {WallDrive::Kind::velocity, 0.1};
  drives[bottom] = {WallDrive::Kind::fixed, 0};
  set_drives(engine, drives);
  engine.advance(half);
  const Energies after = energies_of(engine);
  const double stored =
      after.kinetic + after.elastic + after.adhesive - before.kinetic - before.elastic - before.adhesive;
  const double lost =
      after.dissipated_normal + after.dissipated_friction + after.dissipated_drag + after.dissipated_breakage;
  EXPECT_GT(after.dissipated_normal, 0);
  EXPECT_GT(after.dissipated_drag, 0);
  EXPECT_GE(after.dissipated_friction, 0);
  return {std::abs(stored + lost - after.work_walls - after.work_gravity), before.elastic + std::abs(after.work_walls)};
}

class EnergyBalance : public ::testing::TestWithParam<Case> {};

TEST_P(EnergyBalance, ClosesAndConverges) {
  const Case c = GetParam();
  const Balance coarse = run(c, 1.0 / 500), fine = run(c, 1.0 / 2000);
  RecordProperty("share", std::to_string(1e9 * coarse.gap / coarse.throughput) + "e-9");
  EXPECT_LT(coarse.gap, 3e-6 * coarse.throughput);
  EXPECT_LT(fine.gap, 3e-7 * fine.throughput);
  const double order = std::log2(coarse.gap / fine.gap) / 2;
  RecordProperty("order", std::to_string(order));
  EXPECT_GT(order, c.order);
}

INSTANTIATE_TEST_SUITE_P(All, EnergyBalance,
                         ::testing::Values(Case{"verlet", IntegratorKind::velocity_verlet, dem::Linear{},
                                                dem::RegularisedCoulomb{}, dem::NoAdhesion{}, false, 1.7},
                                           Case{"verlet_springs_glue", IntegratorKind::velocity_verlet, dem::Linear{},
                                                dem::CundallStrack{}, dem::GeometricalAdhesion{}, false, 1.0},
                                           Case{"verlet_breaking", IntegratorKind::velocity_verlet, dem::Linear{},
                                                dem::CundallStrack{}, dem::BreakingAdhesion{}, false, 1.0},
                                           Case{"verlet_periodic", IntegratorKind::velocity_verlet, dem::Linear{},
                                                dem::CundallStrack{}, dem::NoAdhesion{}, true, 1.7},
                                           Case{"leapfrog_hertz", IntegratorKind::leapfrog, dem::Hertz{},
                                                dem::RegularisedCoulomb{}, dem::NoAdhesion{}, false, 1.7},
                                           Case{"gear", IntegratorKind::gear5, dem::Linear{}, dem::RegularisedCoulomb{},
                                                dem::NoAdhesion{}, false, 1.0},
                                           Case{"gear_hertz_periodic", IntegratorKind::gear5, dem::Hertz{},
                                                dem::RegularisedCoulomb{}, dem::NoAdhesion{}, true, 1.0}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace arenite::dem
