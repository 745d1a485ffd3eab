#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "grains/dem/glue.hpp"
#include "support.hpp"

namespace arenite::verification {
namespace {

using dem::Adhesion;
using dem::EffectiveRadius;
using dem::Engine;

// The thesis's glue (Table 2.3) and, for the weak cases, a tenth of it; per cylinder of 60 mm.
constexpr double glue = 1.060e6;

/// T 2.1 between two glued disks: F = k h - gamma sqrt(r_eff h).
struct StickyPair {
  double k, gamma, r_eff;
  double force(double h) const { return k * h - gamma * std::sqrt(r_eff * h); }
  double energy(double h) const { return 0.5 * k * h * h - 2.0 / 3 * gamma * std::sqrt(r_eff) * std::pow(h, 1.5); }
  double pull_off() const { return r_eff * gamma * gamma / (4 * k); }
  double pull_off_overlap() const { return r_eff * gamma * gamma / (4 * k * k); }
  double equilibrium() const { return r_eff * gamma * gamma / (k * k); }
};

constexpr double ra = 8.2e-3, rb = 6.2e-3;
const StickyPair bond{k_pom, glue, 4 * ra* rb / (ra + rb)};

dem::ContactParameters glued(Adhesion kind, double restitution = 1) {
  dem::ContactParameters law = frictionless(restitution);
  if (restitution == 1) law.normal_damping = 0;
  law.adhesion = kind;
  law.surface_energy = glue;
  return law;
}

/// Two glued disks with overlap h, each moving with half of the speed of separation (by mass).
Packing pair(double h, double separation_speed = 0, std::uint8_t zone_b = 1) {
  Packing p = box(1, 1);
  add(p, {{0.5, 0.5}, ra, pom, {}, 0, 1});
  add(p, {{0.5 + ra + rb - h, 0.5}, rb, pom, {}, 0, zone_b});
  const double m = reduced(mass(p, 0), mass(p, 1));
  p.grains.velocity[0].x = -separation_speed * m / mass(p, 0);
  p.grains.velocity[1].x = separation_speed * m / mass(p, 1);
  return p;
}
double pair_mass() {
  const Packing p = pair(0);
  return reduced(mass(p, 0), mass(p, 1));
}
double overlap(const Packing& p) { return ra + rb - norm(p.grains.position[1] - p.grains.position[0]); }
double fine_step() { return contact_time(pair_mass(), k_pom) / 1000; }

TEST(Adhesion, ForceIsKhMinusGammaRootRh) {
  for (const double share : {0.01, 0.25, 0.5, 1.0, 3.0}) {
    const double h = share * bond.equilibrium();
    Engine engine(pair(h), glued(dem::GeometricalAdhesion{}), with_step(fine_step()));
    const Packing p = packing_of(engine);
    ASSERT_EQ(p.contacts.size(), 1u);
    EXPECT_EQ(p.contacts.glued[0], 1);
    EXPECT_NEAR(p.contacts.fn[0], bond.force(h), 1e-9 * bond.pull_off());
  }
}

TEST(Adhesion, EffectiveRadiusIsFourReducedByDefaultAndTheOthersOnRequest) {
  const std::pair<EffectiveRadius, double> options[] = {{EffectiveRadius::four_reduced, 4 * ra * rb / (ra + rb)},
                                                        {EffectiveRadius::sum, ra + rb},
                                                        {EffectiveRadius::geometric_mean, 2 * std::sqrt(ra * rb)}};
  const double h = 1e-5;
  for (const auto& [option, r_eff] : options) {
    dem::ContactParameters law = glued(dem::GeometricalAdhesion{});
    law.effective_radius = option;
    Engine engine(pair(h), law, with_step(fine_step()));
    const double expected = k_pom * h - glue * std::sqrt(r_eff * h);
    EXPECT_NEAR(packing_of(engine).contacts.fn.at(0), expected, 1e-9 * std::abs(expected));
  }
}

TEST(Adhesion, ActsOnlyBetweenTwoGluedGrains) {
  const double h = 1e-5;
  Engine engine(pair(h, 0, 0), glued(dem::GeometricalAdhesion{}), with_step(fine_step()));
  EXPECT_NEAR(packing_of(engine).contacts.fn.at(0), k_pom * h, 1e-9 * k_pom * h);
  EXPECT_EQ(packing_of(engine).contacts.glued.at(0), 0);

  dem::ContactParameters by_pair = glued(dem::GeometricalAdhesion{});
  by_pair.glued_pairs = {{0, 1}};
  Packing p = pair(h, 0, 0);
  p.grains.zone[0] = 0;
  Engine named(p, by_pair, with_step(fine_step()));
  EXPECT_NEAR(packing_of(named).contacts.fn.at(0), bond.force(h), 1e-9 * bond.pull_off());
}

TEST(Adhesion, PullOffForceIsRGammaSquaredOver4kAtItsOverlap) {
  // Torn apart faster than the bond can hold; the largest tension passed and the overlap there are the closed forms'.
  const double escape = std::sqrt(2 * -bond.energy(bond.equilibrium()) / pair_mass());
  Engine engine(pair(bond.equilibrium(), 1.5 * escape), glued(dem::GeometricalAdhesion{}), with_step(fine_step()));
  double tension = 0, where = 0;
  for (int step = 0; step < 20000; ++step) {
    engine.advance(1);
    const Packing p = packing_of(engine);
    if (p.contacts.size() == 0) break;
    if (p.contacts.fn[0] < tension) {
      tension = p.contacts.fn[0];
      where = p.contacts.overlap[0];
    }
  }
  EXPECT_NEAR(-tension, bond.pull_off(), 1e-5 * bond.pull_off());
  EXPECT_NEAR(where, bond.pull_off_overlap(), 1.5 * escape * fine_step());
}

TEST(Adhesion, ADampedPairRestsAtTheOverlapOfZeroForce) {
  for (const dem::Adhesion& kind :
       std::initializer_list<dem::Adhesion>{dem::GeometricalAdhesion{}, dem::BreakingAdhesion{}}) {
    Engine engine(pair(0.6 * bond.equilibrium()), glued(kind, 0.2), with_step(fine_step()));
    engine.advance(60000);
    // Positions of half a metre stop moving when a step's way is below their last bit: 1e-13 m.
    EXPECT_NEAR(overlap(packing_of(engine)), bond.equilibrium(), 1e-8 * bond.equilibrium());
  }
}

TEST(Adhesion, EscapeSpeedIsThatOfTheBondEnergyAndTheRestIsKept) {
  // E(h_eq) = -k h_eq^2/6. The force falls as sqrt(h) at the end, so a step costs (dt/T)^(3/2) of the energy there.
  const double depth = k_pom * bond.equilibrium() * bond.equilibrium() / 6;
  EXPECT_NEAR(depth, -bond.energy(bond.equilibrium()), 1e-12 * depth);
  const double escape = std::sqrt(2 * depth / pair_mass());
  for (const auto integrator : integrators)
    for (const double share : {0.99, 1.01, 1.25}) {
      SCOPED_TRACE(std::string(name(integrator)) + ", " + std::to_string(share));
      Engine engine(pair(bond.equilibrium(), share * escape), glued(dem::GeometricalAdhesion{}),
                    with_step(fine_step(), integrator));
      double farthest = bond.equilibrium();
      for (int part = 0; part < 400; ++part) {
        engine.advance(100);
        farthest = std::min(farthest, overlap(packing_of(engine)));
      }
      if (share < 1) {
        EXPECT_GT(farthest, 0);
      } else {
        const Packing p = packing_of(engine);
        EXPECT_EQ(p.contacts.size(), 0u);
        const double speed = p.grains.velocity[1].x - p.grains.velocity[0].x,
                     expected = escape * std::sqrt(share * share - 1);
        EXPECT_NEAR(speed, expected, 2e-3 * escape);
      }
    }
}

/// Two glued disks that hang: A is wedged between the side walls by a spring of friction, B hangs below it by the bond.
struct Hanging {
  Packing p = box(2 * ra - 2e-5, 0.2);
  explicit Hanging(double h) {
    add(p, {{ra - 1e-5, 0.1}, ra, pom, {}, 0, 1});
    add(p, {{ra - 1e-5, 0.1 - ra - rb + h}, rb, pom, {}, 0, 1});
  }
};

TEST(Adhesion, CarriesAWeightJustBelowThePullOffForceAndDropsOneJustAbove) {
  for (const double share : {0.98, 1.02}) {
    Hanging hanging(bond.equilibrium());
    dem::ContactParameters law = glued(dem::GeometricalAdhesion{}, 0.2);
    law.friction_law = dem::CundallStrack{};
    law.friction = 0;
    law.wall_friction = 1e6;
    Engine engine(hanging.p, law, with_step(contact_time(pair_mass(), k_pom) / 50));
    set_drag(engine, 2e4);
    const double g = share * bond.pull_off() / mass(hanging.p, 1);
    for (int part = 1; part <= 200; ++part) {
      set_gravity(engine, {0, -g * part / 200});
      engine.advance(200);
    }
    engine.advance(20000);
    const Packing now = packing_of(engine);
    EXPECT_EQ(find_contact(now, 0, 1).has_value(), share < 1) << share;
    if (const auto c = find_contact(now, 0, 1)) {
      EXPECT_NEAR(now.contacts.fn[*c], -share * bond.pull_off(), 1e-3 * bond.pull_off());
    }
  }
}

/// Torn apart and thrown together again by the side walls.
Packing after_return(Adhesion kind) {
  const double escape = std::sqrt(2 * -bond.energy(bond.equilibrium()) / pair_mass());
  Packing p = pair(bond.equilibrium(), 2 * escape);
  p.domain.wall[left].position = p.grains.position[0].x - ra - 1e-4;
  p.domain.wall[right].position = p.grains.position[1].x + rb + 1e-4;
  dem::ContactParameters law = glued(kind, 0.9);
  Engine engine(p, law, with_step(contact_time(pair_mass(), k_pom) / 200));
  bool apart = false;
  for (int part = 0; part < 400; ++part) {
    engine.advance(500);
    const Packing now = packing_of(engine);
    apart = apart || !find_contact(now, 0, 1);
    if (apart && find_contact(now, 0, 1) && kind == dem::GeometricalAdhesion{}) {
      engine.advance(100000);
      break;
    }
  }
  EXPECT_TRUE(apart);
  return packing_of(engine);
}

TEST(Adhesion, ReversibleBondsFormAgainAndBrokenOnesDoNot) {
  const Packing reversible = after_return(dem::GeometricalAdhesion{});
  const auto c = find_contact(reversible, 0, 1);
  ASSERT_TRUE(c.has_value());
  EXPECT_EQ(reversible.contacts.glued[*c], 1);
  EXPECT_NEAR(reversible.contacts.overlap[*c], bond.equilibrium(), 1e-3 * bond.equilibrium());

  const Packing broken = after_return(dem::BreakingAdhesion{});
  if (const auto d = find_contact(broken, 0, 1)) {
    EXPECT_EQ(broken.contacts.glued[*d], 0);
    EXPECT_GE(broken.contacts.fn[*d], -1e-6 * bond.pull_off());
  }
}

TEST(Adhesion, EnergyIsBalancedWhenABondBreaksForGood) {
  const double depth = -bond.energy(bond.equilibrium());
  const double escape = std::sqrt(2 * depth / pair_mass());
  dem::IntegrationParameters how = with_step(fine_step());
  how.track_energy = true;
  Engine engine(pair(bond.equilibrium(), 1.5 * escape), glued(dem::BreakingAdhesion{}), how);
  const Energies start = energies_of(engine);
  EXPECT_NEAR(start.elastic + start.adhesive, -depth, 1e-9 * depth);
  engine.advance(20000);
  EXPECT_EQ(packing_of(engine).contacts.size(), 0u);
  const Energies end = energies_of(engine);
  EXPECT_GE(end.dissipated_breakage, -1e-9 * depth);
  EXPECT_NEAR(end.elastic + end.adhesive, 0, 1e-12 * depth);
  EXPECT_NEAR(end.kinetic + end.dissipated_breakage, start.kinetic - depth, 1e-3 * depth);
}

TEST(Adhesion, RaisesTheFrictionCapByThePullOffForceAndLowersItAsPrinted) {
  // At h_eq the normal force is zero, so the cap is mu |F_c|; as printed it is negative, that is none.
  for (const auto cap : {dem::FrictionCap::raised_by_adhesion, dem::FrictionCap::as_printed})
    for (const double h : {bond.equilibrium(), 3 * bond.equilibrium()}) {
      dem::ContactParameters law = glued(dem::GeometricalAdhesion{});
      law.friction_law = dem::RegularisedCoulomb{};
      law.friction = 0.3;
      law.sliding_viscosity = 100;
      law.friction_cap = cap;
      Packing p = pair(h);
      p.grains.velocity[0].y = 1000;  // far beyond what the viscosity would carry
      Engine engine(p, law, with_step(fine_step()));
      const Packing now = packing_of(engine);
      const double raised = cap == dem::FrictionCap::raised_by_adhesion ? bond.pull_off() : -bond.pull_off();
      const double expected = std::max(0.0, 0.3 * (bond.force(h) + raised));
      EXPECT_NEAR(std::abs(now.contacts.ft.at(0)), expected, 1e-9 * bond.pull_off());
      EXPECT_LE(now.contacts.force_on_i(0).y, 0);
    }
}

TEST(Adhesion, CanBeSetLaterAndBreakingBondsThenJoinOnlyThePairsThatTouch) {
  Packing p = pair(bond.equilibrium());
  add(p,
      {{0.5, 0.5 - ra - rb - 1e-5}, rb, pom, {0, 0.05}, 0, 1});  // comes near from below, touches after the glue is set
  for (const dem::Adhesion& kind :
       std::initializer_list<dem::Adhesion>{dem::GeometricalAdhesion{}, dem::BreakingAdhesion{}}) {
    Engine engine(p, glued(kind), with_step(fine_step()));
    set_glue(engine, false);
    engine.advance(2);
    EXPECT_NEAR(packing_of(engine).contacts.fn.at(0), k_pom * bond.equilibrium(), 1e-2 * bond.pull_off());
    set_glue(engine, true);
    engine.advance(2);
    EXPECT_NEAR(packing_of(engine).contacts.fn.at(0), 0, 1e-2 * bond.pull_off());
    double tension = 0;
    for (int part = 0; part < 3000; ++part) {
      engine.advance(10);
      const Packing now = packing_of(engine);
      if (const auto c = find_contact(now, 0, 2)) tension = std::min(tension, now.contacts.fn[*c]);
    }
    if (kind == dem::GeometricalAdhesion{}) {
      EXPECT_NEAR(tension, -bond.pull_off(), 1e-2 * bond.pull_off());
    } else {
      EXPECT_EQ(tension, 0);
    }
  }
}

}  // namespace
}  // namespace arenite::verification
