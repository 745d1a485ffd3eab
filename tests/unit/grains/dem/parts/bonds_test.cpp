#include "grains/dem/parts/bonds.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/run_stage.hpp"
#include "grains/dem/setup.hpp"
#include "unit/grains/dem/samples.hpp"

namespace arenite::dem {
namespace {

/// Bonds of 2 GPa and 1 MPa between disks that do not rub.
ContactParameters cemented(double strength = 1e30) {
  ContactParameters contact;
  contact.friction = 0;
  contact.restitution = 1;
  ParallelBond bond;
  bond.modulus = 2e9;
  bond.tensile_strength = bond.cohesion = strength;
  contact.bonds = bond;
  return contact;
}

/// Two touching disks of unequal radii, the line between them at this angle.
Packing pair_of_disks(double angle = 0.3) {
  Packing p = testing::empty_container(1, 1);
  testing::add_grain(p, 0.5, 0.5, 0.01);
  testing::add_grain(p, 0.5 + 0.016 * std::cos(angle), 0.5 + 0.016 * std::sin(angle), 0.006);
  return p;
}

Sample bonded(const Packing& start, const ContactParameters& contact) {
  Sample s = make_sample(start, contact, {}, find_kernel<2>("auto"));
  bond_near_pairs(s);
  list_anew(s, ThreadPool());
  return s;
}

void move(Sample& s, std::size_t disk, Vec2 by, double turn) {
  s.record[disk].place += by;
  s.angle[disk] += turn;
}

SlotForce<2> force_on_bond(Sample& s) {
  the<Bonds>(s).add_forces(s, ThreadPool());
  return s.list.force[the<Bonds>(s).place(s.list, 0)];
}

TEST(Bonds, ForcesAreMinusTheGradientOfTheEnergyHoweverFarThePairHasTurned) {
  for (const double turned : {0.0, 0.02, 2.0, 30.0}) {
    Sample s = bonded(pair_of_disks(), cemented());
    ASSERT_EQ(the<Bonds>(s).slots.size(), 1u);
    const auto i = static_cast<std::size_t>(the<Bonds>(s).slots[0].i),
               j = static_cast<std::size_t>(the<Bonds>(s).slots[0].j);
    // As a rigid body by `turned`, and then a strain of all three kinds.
    const Vec2 d = s.record[j].place - s.record[i].place, e{std::cos(turned), std::sin(turned)};
    move(s, j, Vec2{e.x * d.x - e.y * d.y, e.y * d.x + e.x * d.y} - d + Vec2{2e-5, -4e-5}, turned + 0.003);
    move(s, i, {}, turned - 0.004);
    const SlotForce<2> f = force_on_bond(s);
    const auto slope = [&](std::size_t disk, Vec2 way, double turn) {
      const double h = 1e-7;
      move(s, disk, h * way, h * turn);
      const double above = bond_energy(s);
      move(s, disk, -2 * h * way, -2 * h * turn);
      const double below = bond_energy(s);
      move(s, disk, h * way, h * turn);
      return (above - below) / (2 * h);
    };
    const double scale = norm(f.on_i);
    EXPECT_GT(scale, 100);
    EXPECT_NEAR(f.on_i.x, -slope(i, {1, 0}, 0), 1e-6 * scale) << turned;
    EXPECT_NEAR(f.on_i.y, -slope(i, {0, 1}, 0), 1e-6 * scale) << turned;
    EXPECT_NEAR(-f.on_i.x, -slope(j, {1, 0}, 0), 1e-6 * scale) << turned;
    EXPECT_NEAR(f.torque_i, -slope(i, {}, 1), 1e-6 * scale * 0.01) << turned;
    EXPECT_NEAR(f.torque_j, -slope(j, {}, 1), 1e-6 * scale * 0.01) << turned;
    // Angular momentum: the torques and the couple of the forces vanish together.
    const Vec2 branch = beam_motion(s, the<Bonds>(s).slots[0]).branch;
    EXPECT_NEAR(cross(branch, f.on_i) + f.torque_i + f.torque_j, 0, 1e-12 * scale * 0.016);
  }
}

TEST(Bonds, StiffnessOfThePairIsThatOfABeam) {
  // Half width 6 mm, A = 2 R t, l = 16 mm: k_n = E A/l; k_s = k_n/2.5; k_b = E I/l with I = 2 R^3 t/3.
  const double area = 2 * 0.006 * 0.06, k = 2e9 * area / 0.016,
               bending = 2e9 * (2.0 / 3 * std::pow(0.006, 3) * 0.06) / 0.016;
  Sample s = bonded(pair_of_disks(0), cemented());
  const auto j = static_cast<std::size_t>(the<Bonds>(s).slots[0].j);
  move(s, j, {1e-6, 0}, 0);  // pulled
  EXPECT_NEAR(std::abs(force_on_bond(s).on_i.x), k * 1e-6, 1e-8 * k * 1e-6);
  move(s, j, {-1e-6, 1e-6}, 0);  // sheared
  const SlotForce<2> across = force_on_bond(s);
  EXPECT_NEAR(std::abs(across.on_i.y), k / 2.5 * 1e-6, 1e-6 * k * 1e-6);
  EXPECT_NEAR(std::abs(across.torque_i + across.torque_j), k / 2.5 * 1e-6 * 0.016, 1e-6 * k * 1e-6 * 0.016);
  move(s, j, {0, -1e-6}, 1e-5);  // turned alone: bent, and sheared by its arm of 6 mm
  const SlotForce<2> bent = force_on_bond(s);
  const auto i = static_cast<std::size_t>(the<Bonds>(s).slots[0].i);
  ASSERT_GT(s.record[i].radius, s.record[j].radius);
  EXPECT_NEAR(bent.torque_i, bending * 1e-5 - k / 2.5 * 0.006 * 1e-5 * 0.010, 1e-9 * bending);
  EXPECT_NEAR(bent.torque_j, -bending * 1e-5 - k / 2.5 * 0.006 * 1e-5 * 0.006, 1e-9 * bending);
}

/// Moves the second disk until the bond breaks; how it broke, and the way made.
std::pair<BondBreak, double> way_to_break(const ContactParameters& contact, Vec2 way, double turn, double step) {
  Sample s = bonded(pair_of_disks(0), contact);
  const auto j =
      static_cast<std::size_t>(the<Bonds>(s).slots[0].i == 0 ? the<Bonds>(s).slots[0].j : the<Bonds>(s).slots[0].i);
  const std::size_t small = s.record[j].radius < 0.008 ? j : 1 - j;
  for (int n = 1; n <= 4000; ++n) {
    move(s, small, step * way, step * turn);
    force_on_bond(s);
    if (the<Bonds>(s).all[0].broken != BondBreak::none) return {the<Bonds>(s).all[0].broken, n * step};
  }
  return {BondBreak::none, 0};
}

TEST(Bonds, BreaksAtTheStrengthInTensionShearAndBending) {
  ContactParameters contact = cemented();
  auto& law = std::get<ParallelBond>(contact.bonds);
  law.tensile_strength = 1e6;
  // sigma = E u/l
  const double pulled = 1e6 * 0.016 / 2e9, step = pulled / 1000.5;
  EXPECT_EQ(way_to_break(contact, {1, 0}, 0, step).first, BondBreak::tension);
  EXPECT_NEAR(way_to_break(contact, {1, 0}, 0, step).second, pulled, 1.01 * step);
  EXPECT_EQ(way_to_break(contact, {-1, 0}, 0, step).first, BondBreak::none);
  // |M| R/I = E theta R/l, R = 6 mm, where cohesion holds the shear
  const double bent = 1e6 * 0.016 / (2e9 * 0.006), turn = bent / 1000.5;
  EXPECT_EQ(way_to_break(contact, {}, 1, turn).first, BondBreak::bending);
  EXPECT_NEAR(way_to_break(contact, {}, 1, turn).second, bent, 1.01 * turn);
  // tau = E u/(2.5 l); pressed with it by a like way, the cohesion is raised by tan(phi) E u/l
  law.tensile_strength = 1e30;
  law.cohesion = 1e6;
  const double sheared = 2.5 * 1e6 * 0.016 / 2e9, slide = sheared / 1000.5;
  EXPECT_EQ(way_to_break(contact, {0, 1}, 0, slide).first, BondBreak::shear);
  EXPECT_NEAR(way_to_break(contact, {0, 1}, 0, slide).second, sheared, 1e-3 * sheared + 1.01 * slide);
  law.friction_angle = std::atan(0.2);
  const auto excess = [](double u) {  // of the shear stress over the strength after a way u down and across
    const double l = 0.016, distance = std::hypot(l - u, u);
    return 2e9 / 2.5 * std::atan(u / (l - u)) - 1e6 - 0.2 * 2e9 * (l - distance) / l;
  };
  const double both = way_to_break(contact, {-1, 1}, 0, slide).second;
  EXPECT_NEAR(both, 2 * sheared, 0.02 * sheared);
  EXPECT_GE(excess(both), 0);
  EXPECT_LT(excess(both - slide), 0);
}

TEST(Bonds, JoinGrainsThatTouchOrNearlyAndOnlyMarkedOnesWhereGluedGrainsAre) {
  Packing p = testing::empty_container(1, 1);
  for (const double x : {0.1, 0.12, 0.1403, 0.2}) testing::add_grain(p, x, 0.5, 0.01);
  ContactParameters contact = cemented();
  EXPECT_EQ(count_bonds(bonded(p, contact)).intact, 1u);
  std::get<ParallelBond>(contact.bonds).gap = 0.05;
  EXPECT_EQ(count_bonds(bonded(p, contact)).intact, 2u);
  p.grains.zone = {0, 1, 1, 1};
  EXPECT_EQ(count_bonds(bonded(p, contact)).intact, 1u);
}

TEST(Bonds, StrengthsScatterAsAskedAndByGrainsAlone) {
  ContactParameters contact = cemented();
  auto& law = std::get<ParallelBond>(contact.bonds);
  law.scatter = 0.2;
  law.gap = 0.1;
  const auto slots = [&] {
    const Sample s = bonded(testing::crowd(60, 60, 6), contact);
    return the<Bonds>(s).slots;
  };
  const std::vector<BondSlot> bonds = slots();
  double sum = 0, squares = 0;
  for (const BondSlot& b : bonds) {
    sum += b.strength;
    squares += b.strength * b.strength;
  }
  const double n = static_cast<double>(bonds.size()), mean = sum / n;
  ASSERT_GT(n, 1000);
  EXPECT_NEAR(mean, 1, 4 * 0.2 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n - mean * mean), 0.2, 4 * 0.2 / std::sqrt(2 * n));
  law.modulus *= 2;
  EXPECT_EQ(slots()[77].strength, bonds[77].strength);
  law.seed = 2;
  EXPECT_NE(slots()[77].strength, bonds[77].strength);
}

TEST(Bonds, NoneAreMadeWhereTheLawHasNone) {
  Engine engine(pair_of_disks(), {}, {});
  EXPECT_THROW(make_bonds(engine), InputError);
}

TEST(Bonds, StepIsShortenedOrRefused) {
  ContactParameters contact = cemented();
  std::get<ParallelBond>(contact.bonds).modulus = 2e12;
  Engine engine(pair_of_disks(), contact, {});
  const double before = engine.dt;
  make_bonds(engine);
  EXPECT_LT(engine.dt, 0.1 * before);
  IntegrationParameters given;
  given.time_step = before;
  Engine stubborn(pair_of_disks(), contact, given);
  EXPECT_THROW(make_bonds(stubborn), InputError);
}

/// Grains of two sizes, bonded, of which a wall that closes in breaks some.
Engine crushed(const Packing& p, int threads, std::int64_t steps) {
  ContactParameters contact = cemented(5e7);
  contact.friction = 0.5;
  std::get<ParallelBond>(contact.bonds).damping = 0.1;
  IntegrationParameters how;
  how.threads = threads;
  Engine engine(p, contact, how);
  make_bonds(engine);
  testing::squeeze(engine, steps);
  return engine;
}

TEST(Bonds, SameBitsOnTwoThreadsAndRestored) {
  const Packing p = testing::crowd(50, 50, 6, 0.0135);
  Engine a = crushed(p, 1, 1500), b = crushed(p, 2, 1500);
  const BondCount count = count_bonds(a);
  EXPECT_GT(count.intact, 500u);
  EXPECT_GT(count.in_tension + count.in_bending + count.in_shear, 20u);
  EXPECT_EQ(state_hash(a), state_hash(b));
  Engine c = crushed(p, 1, 0);
  for (int n = 0; n < 40; ++n) {  // wherever it stands between two lists and between breaks
    restore_sample(c, save_sample(a));
    a.advance(7);
    c.advance(7);
    ASSERT_EQ(state_hash(a), state_hash(c)) << n;
  }
}

TEST(Bonds, OfAStageAreToldInHistoryStatesAndOutcome) {
  ContactParameters contact = cemented(5e7);
  contact.friction = 0.5;
  Engine engine(testing::crowd(20, 20, 6, 0.0130), contact, {});
  Stage stage;
  stage.bond = true;
  stage.side[right] = {SideDrive::Kind::velocity, 0.5};
  stage.duration = 3e-3;
  StageRun run = begin_stage(engine, stage);
  while (!run.finished) continue_stage(engine, stage, run);
  const auto column = [&](const std::string& name) {
    for (const auto& c : run.result.history.columns)
      if (c.name == name) return c.values;
    return std::vector<double>{};
  };
  const BondCount count = count_bonds(engine);
  ASSERT_GT(count.made() - count.intact, 10u);
  EXPECT_NE(run.result.outcome.find("bonds broken"), std::string::npos);
  EXPECT_EQ(column("bonds").size(), column("time").size());
  EXPECT_EQ(column("bonds").back() + column("broken_in_tension").back() + column("broken_in_bending").back() +
                column("broken_in_shear").back(),
            static_cast<double>(count.made()));
  const Packing& end = run.result.snapshots.back().packing;
  ASSERT_EQ(end.bonds.size(), count.made());
  double energy = 0;
  std::size_t broken = 0;
  for (const Bond& bond : end.bonds) {
    if (bond.broken == BondBreak::none) {
      energy += bond.energy;
      EXPECT_LT(bond.load, 1);
      continue;
    }
    ++broken;
    EXPECT_GE(bond.load, 1);
    EXPECT_EQ(bond.fn, 0);
    EXPECT_GT(bond.time, 0);
    EXPECT_GT(bond.place.x, 0);
  }
  EXPECT_EQ(broken, count.made() - count.intact);
  EXPECT_NEAR(energy, count.energy, 1e-12 * energy);
}

TEST(Bonds, AreHandedOnWithThePacking) {
  const Packing p = testing::crowd(20, 20, 6, 0.0130);
  const Engine a = crushed(p, 1, 1500);
  ContactParameters contact = cemented(5e7);
  const Engine b(packing_of(a), contact, {});
  EXPECT_EQ(count_bonds(b).intact, count_bonds(a).intact);
  EXPECT_EQ(count_bonds(b).made(), count_bonds(a).made());
  EXPECT_NEAR(count_bonds(b).energy, count_bonds(a).energy, 1e-9 * count_bonds(a).energy);
}

}  // namespace
}  // namespace arenite::dem
