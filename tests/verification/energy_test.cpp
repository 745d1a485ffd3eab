#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Adhesion;
using dem::Engine;
using dem::FrictionLaw;
using dem::IntegratorKind;
using dem::NormalLaw;

struct Balance {
  double imbalance, work, lost;
  double relative() const { return std::abs(imbalance) / work; }
};

/// Two walls close in on some tens of disks at a metre a second, until overlaps reach some parts in a thousand. (The
/// share that is lost track of at each new contact grows with the speed.)
Balance compress(const dem::ContactParameters& law, IntegratorKind kind, double share_of_contact_time,
                 const Packing& start = shaken_lattice(7, 7, 1), Vec2 g = {}, double drag = 0) {
  dem::IntegrationParameters how = with_step(shortest_contact_time() / share_of_contact_time, kind);
  how.track_energy = true;
  how.drag = drag;
  Engine engine(start, law, how);
  set_drives(engine, {dem::WallDrive{}, moved(-0.8), moved(1.1), dem::WallDrive{}});
  set_gravity(engine, g);
  const Energies before = energies_of(engine);
  engine.advance(static_cast<std::int64_t>(30 * share_of_contact_time));
  const Energies after = energies_of(engine);
  return {stored(after) - stored(before) + lost(after) - lost(before) - work(after) + work(before),
          std::abs(work(after) - work(before)), lost(after) - lost(before)};
}

std::string describe(NormalLaw normal, FrictionLaw friction, Adhesion adhesion, IntegratorKind kind) {
  return std::string(normal.word()) + ", friction " + std::string(friction.word()) + ", adhesion " +
         std::string(adhesion.word()) + ", " + name(kind);
}

TEST(Energy, IsClosedToAMillionthOfTheWorkAtAStepOfTcOver500ForEveryLaw) {
  Packing start = shaken_lattice(7, 7, 1);
  for (std::size_t i = 0; i < start.grains.size(); ++i) start.grains.zone[i] = i % 3 != 0;
  for (const dem::NormalLaw& normal : std::initializer_list<dem::NormalLaw>{dem::Linear{}, dem::Hertz{}})
    for (const dem::FrictionLaw& friction :
         std::initializer_list<dem::FrictionLaw>{dem::NoFriction{}, dem::RegularisedCoulomb{}, dem::CundallStrack{}})
      for (const dem::Adhesion& adhesion :
           std::initializer_list<dem::Adhesion>{dem::NoAdhesion{}, dem::GeometricalAdhesion{}, dem::BreakingAdhesion{}})
        for (const auto kind : integrators) {
          SCOPED_TRACE(describe(normal, friction, adhesion, kind));
          dem::ContactParameters law;
          law.normal = normal;
          law.friction_law = friction;
          law.restitution = 0.3;
          law.adhesion = adhesion;
          law.surface_energy = normal == dem::Hertz{} ? 0.05e6 : 0.3e6;  // a like share of the load
          const Balance b = compress(law, kind, 500, start);
          EXPECT_GT(b.work, 0.1);
          EXPECT_GT(b.lost, 1e-4 * b.work);
          EXPECT_LT(b.relative(), 1e-6);
        }
}

TEST(Energy, OfRollingIsClosedToo) {
  for (const dem::RollingLaw& rolling :
       std::initializer_list<dem::RollingLaw>{dem::ConstantTorque{0.3}, dem::ElasticPlasticRolling{0.3, 0.3}})
    for (const auto kind : integrators) {
      SCOPED_TRACE(std::string(rolling.word()) + ", " + name(kind));
      dem::ContactParameters law;
      law.rolling = rolling;
      EXPECT_LT(compress(law, kind, 500).relative(), 1e-6);
    }
}

TEST(Energy, GravityAndDragAreAccountedFor) {
  for (const auto kind : integrators) {
    SCOPED_TRACE(name(kind));
    const Balance b = compress({}, kind, 500, shaken_lattice(7, 7, 3), {300, -5e3}, 500);
    EXPECT_LT(b.relative(), 1e-6);
  }
}

TEST(Energy, AClippedDashpotIsAccountedFor) {
  dem::ContactParameters law;
  law.attractive_dashpot = false;
  EXPECT_LT(compress(law, IntegratorKind::velocity_verlet, 500).relative(), 1e-6);
}

/// A lattice squeezed so that its contacts never open while its disks tremble: smooth forces, so orders can be seen.
Packing squeezed() {
  Packing p = box(12e-3 * 6.5, 12e-3 * (1 + 5 * std::sqrt(0.75)));
  RandomStream random(5, Purpose::test);
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c)
      add(p, {{6e-3 + 12e-3 * (c + 0.5 * (r % 2)), 6e-3 + 12e-3 * std::sqrt(0.75) * r},
              6.01e-3,
              pom,
              {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)},
              random.uniform(-3, 3)});
  return p;
}

TEST(Energy, ConvergesAtTheIntegratorsOrder) {
  dem::ContactParameters law;
  law.friction_law = dem::RegularisedCoulomb{};
  law.restitution = 0.8;
  law.sliding_viscosity = 30;
  law.friction = 10;  // no contact reaches the cap's kink
  for (const auto kind : integrators) {
    double error[3];
    for (int level = 0; level < 3; ++level) {
      dem::IntegrationParameters how = with_step(shortest_contact_time() / (20 << level), kind);
      how.track_energy = true;
      Engine engine(squeezed(), law, how);
      set_drives(engine, {dem::WallDrive{}, moved(-0.3), dem::WallDrive{}, dem::WallDrive{}});
      const Energies a = energies_of(engine);
      engine.advance(40 << level);
      const Energies b = energies_of(engine);
      error[level] = std::abs(stored(b) - stored(a) + lost(b) - lost(a) - work(b) + work(a)) / stored(a);
    }
    EXPECT_GT(std::log2(error[0] / error[1]), 1.7) << name(kind) << " " << error[0] << " " << error[1];
    EXPECT_GT(std::log2(error[1] / error[2]), 1.7) << name(kind) << " " << error[1] << " " << error[2];
    EXPECT_LT(error[2], 1e-3) << name(kind);
  }
}

TEST(Energy, SlowCompressionOfOneDiskCostsTwoSpringsEnergy) {
  // Between two plates: each contact stores k h^2/2, and the moving plate has done both; kinetic energy of the slow
  // move is (speed/(omega h))^2 of it.
  Packing p = box(1, 12.4e-3);
  add(p, {{0.5, 6.2e-3}, 6.2e-3});
  const double speed = 0.05, dt = contact_time(mass(p, 0), 2 * k_pom) / 200;
  dem::IntegrationParameters how = with_step(dt);
  how.track_energy = true;
  Engine engine(p, frictionless(0.2), how);
  set_drives(engine, {dem::WallDrive{}, dem::WallDrive{}, dem::WallDrive{}, moved(-speed)});
  const std::int64_t steps = 20000;
  engine.advance(steps);
  const double h = 0.5 * speed * dt * static_cast<double>(steps), expected = k_pom * h * h;
  const Energies e = energies_of(engine);
  EXPECT_NEAR(e.elastic, expected, 1e-2 * expected);
  EXPECT_NEAR(e.work_walls - e.dissipated_normal - e.kinetic, e.elastic, 1e-6 * expected);
}

/// Relative imbalance of a sample whose loading changes on the way, force-controlled walls or periodic edges included.
double imbalance_under_changing_loads(IntegratorKind kind, bool periodic) {
  dem::ContactParameters law;
  law.friction_law = dem::CundallStrack{};
  law.restitution = 0.3;
  dem::IntegrationParameters how = with_step(shortest_contact_time() / 500, kind);
  how.track_energy = true;
  Engine engine(shaken_lattice(8, 8, 4, periodic), law, how);
  const Energies before = energies_of(engine);
  set_drives(engine, {dem::WallDrive{}, moved(-0.8), moved(1.1), dem::WallDrive{}});
  engine.advance(15000);
  set_drives(engine, {dem::WallDrive{}, pressed(3000), pressed(4000), dem::WallDrive{}});
  set_gravity(engine, periodic ? Vec2{} : Vec2{100, -500});
  engine.advance(10000);
  set_drag(engine, 200);
  set_drives(engine, {dem::WallDrive{}, moved(0.1), pressed(2000), moved(-0.2)});
  engine.advance(5000);
  const Energies after = energies_of(engine);
  EXPECT_GT(work(after), 0.1);
  return std::abs(stored(after) - stored(before) + lost(after) - work(after)) / work(after);
}

TEST(Energy, StaysClosedUnderServoWallsPeriodicEdgesAndLoadsThatChange) {
  for (const auto kind : integrators)
    for (const bool periodic : {false, true})
      // A load changed at once starts Gear's higher derivatives anew.
      EXPECT_LT(imbalance_under_changing_loads(kind, periodic), 2e-6)
          << name(kind) << (periodic ? ", periodic" : ", walls");
}

TEST(Energy, OfAnElasticGasStaysWhereItIs) {
  // Verlet's energy wavers by (omega dt)^2 at collisions and does not drift; Gear's loses no more in this time.
  for (const auto kind : integrators) {
    const Packing start = shaken_lattice(8, 8, 3, true, 1);
    Engine engine(start, elastic(), with_step(shortest_contact_time() / 100, kind));
    const double at_start = stored(energies_of(engine));
    double worst = 0;
    for (int part = 0; part < 50; ++part) {
      engine.advance(800);
      worst = std::max(worst, std::abs(stored(energies_of(engine)) / at_start - 1));
    }
    EXPECT_LT(worst, 2e-4) << name(kind);
  }
}

/// Normal force and potential of a single contact of overlap h.
std::pair<double, double> law_at(double h, const dem::ContactParameters& law, bool wall) {
  Packing p = box(1, 1);
  const double r = 6.2e-3;
  if (wall) {
    add(p, {{0.5, r - h}, r, pom, {}, 0, 1});
  } else {
    add(p, {{0.5, 0.5}, r, pom, {}, 0, 1});
    add(p, {{0.5, 0.5 + 2 * r - h}, r, hdpe, {}, 0, 1});
  }
  dem::IntegrationParameters how = with_step(1e-8);
  how.track_energy = true;
  const Engine engine(p, law, how);
  const Energies e = energies_of(engine);
  return {packing_of(engine).contacts.fn.at(0), e.elastic + e.adhesive};
}

TEST(Energy, NormalForceIsMinusItsGradientForEveryLaw) {
  for (const dem::NormalLaw& normal : std::initializer_list<dem::NormalLaw>{dem::Linear{}, dem::Hertz{}})
    for (const dem::Adhesion& adhesion :
         std::initializer_list<dem::Adhesion>{dem::NoAdhesion{}, dem::GeometricalAdhesion{}, dem::BreakingAdhesion{}})
      for (const bool wall : {false, true})
        for (const double h : {3e-6, 2e-5, 2e-4}) {
          SCOPED_TRACE(describe(normal, dem::NoFriction{}, adhesion, IntegratorKind::velocity_verlet));
          dem::ContactParameters law = elastic();
          law.normal = normal;
          law.adhesion = adhesion;
          law.surface_energy = 0.1e6;
          const double d = 1e-3 * h;
          const double slope = (law_at(h + d, law, wall).second - law_at(h - d, law, wall).second) / (2 * d);
          // Central difference: (d/h)^2/24 of the curvature term.
          const double scale = k_pom * h;
          EXPECT_NEAR(law_at(h, law, wall).first, slope, 1e-6 * scale) << "h = " << h;
        }
}

TEST(Energy, TheTangentialSpringStoresHalfTheSquareOfItsForceOverItsStiffness) {
  // A block on the wall, stuck by friction, hangs on the spring after a sideways push came to rest.
  Packing p = box(1, 1);
  add(p, {{0.5, 6.2e-3 - 1e-5}, 6.2e-3});
  dem::ContactParameters law;
  law.friction_law = dem::CundallStrack{};
  law.friction = 10;
  dem::IntegrationParameters how = with_step(contact_time(mass(p, 0), k_pom) / 100);
  how.track_energy = true;
  how.rotations = false;
  Engine engine(p, law, how);
  const double omega = std::sqrt(k_pom / mass(p, 0)), g = 1e-5 * k_pom / mass(p, 0);
  set_gravity(engine, {0.5 * g, -g});
  set_drag(engine, 0.3 * omega);
  engine.advance(20000);
  const Packing now = packing_of(engine);
  ASSERT_EQ(now.contacts.size(), 1u);
  const double fn = now.contacts.fn[0], ft = now.contacts.ft[0];
  EXPECT_NEAR(std::abs(ft), 0.5 * g * mass(p, 0), 1e-6 * std::abs(ft));
  const double expected = 0.5 * fn * fn / k_pom + 0.5 * ft * ft / (0.8 * k_pom);
  EXPECT_NEAR(energies_of(engine).elastic, expected, 1e-9 * expected);
}

TEST(Momentum, IsConservedInAPeriodicCellWhateverTheContactsDissipate) {
  for (const dem::FrictionLaw& friction :
       std::initializer_list<dem::FrictionLaw>{dem::RegularisedCoulomb{}, dem::CundallStrack{}})
    for (const auto kind : integrators) {
      const Packing start = shaken_lattice(10, 10, 2, true, 2);
      dem::ContactParameters law;
      law.friction_law = friction;
      law.restitution = 0.5;
      law.attractive_dashpot = true;
      Engine engine(start, law, with_step(shortest_contact_time() / 100, kind));
      double scale = 0;
      for (std::size_t i = 0; i < start.grains.size(); ++i) scale += mass(start, i) * norm(velocity(start, i));
      engine.advance(3000);
      const Packing end = packing_of(engine);
      EXPECT_GT(end.contacts.size(), 10u);
      // Rounding of 3000 steps only.
      EXPECT_NEAR(momentum(end).x, momentum(start).x, 1e-12 * scale) << name(kind);
      EXPECT_NEAR(momentum(end).y, momentum(start).y, 1e-12 * scale) << name(kind);
      double still = 0;
      for (std::size_t i = 0; i < end.grains.size(); ++i) still += mass(end, i) * norm(velocity(end, i));
      EXPECT_LT(still, 0.9 * scale);
    }
}

}  // namespace
}  // namespace arenite::verification
