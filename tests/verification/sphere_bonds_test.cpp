// Bonded spheres against closed forms: what holds two of them breaks at the stress asked for, a chain twists by its
// modes, a bent cantilever yields as a beam of springs does, and what tumbles keeps energy and angular momentum.
#include "balance.hpp"
#include "core/error.hpp"
#include "grains/dem/parts/beam_motion.hpp"
#include "grains/dem/save.hpp"
#include "spheres.hpp"

namespace arenite::verification {
namespace {

constexpr double r = 0.005, l = 2.02 * r;  // with a gap, so that bonds act alone

struct Bonded : Spheres {
  ParallelBond law;
  SampleIn<3> s;

  Bonded() : Spheres(1e6) {
    law.modulus = 1e9;
    law.gap = 0.05;
    law.tensile_strength = law.cohesion = 1e15;
    integration.safety = 0.02;
  }
  void bond() {
    contact.bonds = law;
    s = sample();
    make_bonds(s);
  }
  RoundBeam beam(double length = l) const { return law.round_beam(length, r); }
  void go_on(double time) { advance(s, ThreadPool(), std::lround(time / s.dt)); }
  Vec3 angular_momentum() const {
    const GrainsIn<3> g = packing_of(s).grains;
    Vec3 sum;
    for (std::size_t k = 0; k < g.size(); ++k)
      sum += mass(k) * cross(g.position[k], g.velocity[k]) + inertia(k) * g.omega[k];
    return sum;
  }
};

/// How two spheres move against each other, and the stiffness and mobility of that way of their bond.
struct Way {
  BondBreak kind;
  Vec3 velocity, omega_i, omega_j;  ///< of i; j moves the other way
  double rate, stiffness, mobility;
};
std::vector<Way> ways(const Bonded& c, Vec3 n, Vec3 across) {
  const RoundBeam b = c.beam();
  const double m = c.mass(0), turn = 2 / c.inertia(0), shear = 2 / m + 0.25 * l * l * turn;
  return {{BondBreak::tension, 0.1 * n, {}, {}, 0.2, b.normal, 2 / m},
          {BondBreak::bending, {}, across, -across, 2, b.bending, turn},
          {BondBreak::twisting, {}, n, -n, 2, b.twist, turn},
          {BondBreak::shear, {}, across, across, l, b.shear, shear}};
}

/// The largest stress over the strength asked for is what the kinetic energy of that motion makes of it.
TEST(SphereBonds, HoldUpToTheirStrengthAndBreakAtIt) {
  const Vec3 n{1.0 / 3, 2.0 / 3, 2.0 / 3}, across{2.0 / 3, 1.0 / 3, -2.0 / 3};
  for (std::size_t way = 0; way < 4; ++way)
    for (const double share : {0.995, 1.005}) {
      SCOPED_TRACE(way);
      Bonded c;
      c.add(r, {0.05, 0.05, 0.05});
      c.add(r, Vec3{0.05, 0.05, 0.05} - l * n);
      const Way w = ways(c, n, across)[way];
      const RoundBeam b = c.beam();
      const double force = w.rate * std::sqrt(w.stiffness / w.mobility);
      const double stress = force * std::array{b.per_area, b.per_section, b.per_twist, b.per_area}[way];
      (way < 2 ? c.law.tensile_strength : c.law.cohesion) = stress / share;
      auto& g = c.start.grains;
      g.velocity = {w.velocity, -w.velocity};
      g.omega = {w.omega_i, w.omega_j};
      c.bond();
      const double before = energies_of(c.s).kinetic, held = 0.5 * force * force / w.stiffness;
      c.go_on(0.7 * std::numbers::pi / std::sqrt(w.stiffness * w.mobility));
      const BondCount count = count_bonds(c.s);
      EXPECT_EQ(count.intact, share < 1 ? 1U : 0U);
      const BondIn<3> bond = packing_of(c.s).bonds.at(0);
      EXPECT_EQ(bond.broken, share < 1 ? BondBreak::none : w.kind);
      if (share > 1) {
        EXPECT_NEAR(bond.energy, held, 0.02 * held);
        EXPECT_NEAR(energies_of(c.s).kinetic, before - held, 0.02 * held) << "the rest of it flies on";
      }
    }
}

/// A free chain twists by its modes: sin(pi/2N) of twice the frequency of one sphere on one bond.
TEST(SphereBonds, AChainTwistsByItsModes) {
  constexpr int n = 6;
  Bonded c;
  const auto mode = [](int k) { return std::cos(std::numbers::pi * (k + 0.5) / n); };
  for (int k = 0; k < n; ++k) c.add(r, {0.01 + l * k, 0.05, 0.05}, {}, {mode(k), 0, 0});
  c.bond();
  ASSERT_EQ(count_bonds(c.s).intact, n - 1U);
  const double frequency = 2 * std::sqrt(c.beam().twist / c.inertia(0)) * std::sin(std::numbers::pi / (2 * n));
  c.go_on(std::numbers::pi / (2 * frequency));
  const double held = n / 2.0 * 0.5 * c.inertia(0);  // sum of cos^2
  EXPECT_NEAR(energies_of(c.s).elastic, held, 2e-4 * held);
  c.go_on(std::numbers::pi / (2 * frequency));
  for (int k = 0; k < n; ++k) expect_near(packing_of(c.s).grains.omega[k], {-mode(k), 0, 0}, 1e-3);
}

/// A cantilever with an arm across its end: a wall presses the end of the arm, so that the beam is bent and twisted.
/// Its compliance is what the energies of its bonds say (Castigliano).
TEST(SphereBonds, ACantileverBendsAndTwists) {
  Bonded c;
  c.start.materials.push_back({"clamp", 7800e12, 1e6});
  const double tip_radius = 1.3 * r;
  std::vector<Vec3> place;
  for (int k = 0; k < 5; ++k) place.push_back({0.01 + l * k, 0.05, 0.02});
  for (int k = 1; k < 3; ++k) place.push_back(place[4] + Vec3{0, 0, l * k});
  place.push_back(place.back() + Vec3{0, 0, 1.01 * (r + tip_radius)});
  for (const Vec3& each : place) c.add(&each == &place.back() ? tip_radius : r, each);
  c.start.grains.material[0] = 1;
  const double overlap = 2e-5;
  c.start.domain.wall[bottom].position = 0.05 - tip_radius + overlap;
  c.integration.drag = 400;  // of what moves, and the bonds' own of what turns
  c.law.damping = 0.3;
  c.integration.safety = 0.1;
  c.contact.restitution = 0.5;
  c.bond();
  ASSERT_EQ(count_bonds(c.s).intact, 7U);
  c.go_on(0.1);
  const Vec3 tip = place.back();
  double compliance = 0;
  for (std::size_t k = 1; k < place.size(); ++k) {
    const Vec3 way = place[k] - place[k - 1], n = way / norm(way);
    const double share = r / (r + c.start.grains.radius[k]);
    const Vec3 moment = cross(tip - (place[k - 1] + share * way), Vec3{0, 1, 0});
    const double twisted = dot(moment, n);
    const RoundBeam b = c.beam(norm(way));
    compliance += 1 / b.shear + twisted * twisted / b.twist + (dot(moment, moment) - twisted * twisted) / b.bending;
  }
  const double force = c.s.domain.wall[bottom].force, bent = packing_of(c.s).grains.position[7].y - 0.05;
  EXPECT_LT(energies_of(c.s).kinetic, 1e-5 * energies_of(c.s).elastic);
  EXPECT_NEAR(bent / force, compliance, 2e-3 * compliance);
  EXPECT_NEAR(force, overlap / (compliance + 1 / c.start.materials[0].stiffness), 5e-3 * force);
}

/// Strained far and tumbling, without contacts: forces are the gradient of the energy, and no torque comes from within.
TEST(SphereBonds, WhatTumblesKeepsEnergyAndAngularMomentum) {
  Bonded c;
  c.law.modulus = 1e7;
  const Vec3 corner[] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (int k = 0; k < 4; ++k)
    c.add(r, Vec3{0.05, 0.05, 0.05} + l / std::sqrt(8.0) * corner[k], 0.3 * Vec3{corner[k].y, -0.4, corner[k].x},
          60.0 * Vec3{0.5 * corner[k].z, corner[k].x, 1});
  c.bond();
  ASSERT_EQ(count_bonds(c.s).intact, 6U);
  const Vec3 turning = c.angular_momentum();
  const double before = energies_of(c.s).kinetic;
  double most = 0;
  for (int n = 0; n < 20; ++n) {
    c.go_on(2e-3);
    const Energies e = energies_of(c.s);
    most = std::max(most, bond_energy(c.s));
    EXPECT_NEAR(e.kinetic + e.elastic, before, 1e-3 * before);
  }
  EXPECT_GT(most, 0.05 * before);
  const double whole = 4 * c.inertia(0) * 60;
  expect_near(c.angular_momentum(), turning, 1e-9 * whole);
  c.law.modulus = 1e9;
}

/// A block that is crushed and sheared between two walls.
struct Block : Bonded {
  explicit Block(int threads = 1) : pool(threads) {
    law.tensile_strength = 3e5, law.cohesion = 5e5, law.scatter = 0.2, law.damping = 0.05;
    for (int k = 0; k < 64; ++k)
      add(r, Vec3{0.02, 0.0, 0.02} + Vec3{l * (k % 4), l * (k / 4 % 4) + r, l * (k / 16)}, {0, -0.2, 0});
    start.domain.wall[top].position = 4 * l;
    integration.track_energy = true;
    integration.safety = 0.02;
    contact.friction_law = CundallStrack{};
    contact.rolling = ElasticPlasticRolling{0.1, 0.3, 0.05};
    bond();
    WallDrivesIn<3> drives{};
    drives[top] = {DriveKind::velocity, -0.5, {1, 0, 0.3}};
    set_drives(s, drives);
  }
  ThreadPool pool;
};

TEST(SphereBonds, ABlockThatIsCrushedClosesItsEnergyBalance) {
  Block c;
  const Energies before = energies_of(c.s);
  advance(c.s, c.pool, 2000);
  const Energies after = energies_of(c.s);
  const BondCount count = count_bonds(c.s);
  EXPECT_EQ(count.made(), 3U * 48);
  EXPECT_LT(count.intact, count.made());
  EXPECT_GT(after.dissipated_breakage, 0);
  EXPECT_LT(std::abs(imbalance(before, after)), 1e-4 * after.work_walls);
}

TEST(SphereBonds, GoOnFromAStoredStateToTheLastBit) {
  Block one, two(2);
  advance(one.s, one.pool, 1000);
  EXPECT_LT(count_bonds(one.s).intact, count_bonds(one.s).made());
  SampleIn<3> again = Block().s;
  restore_sample(again, save_sample(one.s));
  advance(one.s, one.pool, 500);
  advance(again, one.pool, 500);
  EXPECT_EQ(state_hash(again), state_hash(one.s));
  advance(two.s, two.pool, 1500);
  EXPECT_EQ(state_hash(two.s), state_hash(one.s)) << "whatever the threads";
}

TEST(SphereBonds, TheLoopSaysOfAllWhatTheLawSaysOfOne) {
  Block c;
  advance(c.s, c.pool, 600);
  const auto& bonds = the<BondsIn<3>>(c.s);
  int held = 0;
  for (std::size_t n = 0; n < bonds.slots.size(); ++n) {
    const BondSlotIn<3>& b = bonds.slots[n];
    if (b.state != BondState::holds) continue;
    ++held;
    const BeamMotionIn<3> m = beam_motion(c.s, b);
    const RoundForce f = c.law.elastic(b.beam, m.strain) + beam_dashpots(c.s, b, m);
    const SlotForce<3> one = beam_slot_force(b, m, f), of_loop = c.s.list.force[bonds.place(c.s.list, n)];
    const double size = norm(one.on_i), turning = norm(one.torque_i) + norm(one.torque_j);
    expect_near(of_loop.on_i, one.on_i, 1e-9 * size);
    expect_near(of_loop.torque_i, one.torque_i, 1e-9 * turning);
    expect_near(of_loop.torque_j, one.torque_j, 1e-9 * turning);
  }
  EXPECT_GT(held, 100);
}

TEST(SphereBonds, HaveTheSameBitsByEveryKernel) {
  Block fast, portable;
  portable.s.kernel = &find_kernel<3>("portable");
  for (Block* c : {&fast, &portable}) advance(c->s, c->pool, 1200);
  EXPECT_LT(count_bonds(fast.s).intact, count_bonds(fast.s).made());
  EXPECT_EQ(state_hash(fast.s), state_hash(portable.s)) << fast.s.kernel->name;
}

/// One that is twisted further than the loop goes, by more than a quarter of a turn, is a torsion pendulum still.
TEST(SphereBonds, TwistByMoreThanAQuarterOfATurn) {
  Bonded c;
  c.integration.safety = 5e-4;
  const double turned = 2.0;
  c.add(r, {0.05, 0.05, 0.05});
  c.add(r, {0.05 - l, 0.05, 0.05});
  const double frequency = std::sqrt(2 * c.beam().twist / c.inertia(0));
  c.start.grains.omega = {{0.5 * turned * frequency, 0, 0}, {-0.5 * turned * frequency, 0, 0}};
  c.bond();
  const double stiffness = c.beam().twist;
  double most = 0;
  for (int n = 0; n < 40; ++n) {
    c.go_on(2 * std::numbers::pi / frequency / 40);
    most = std::max(most, bond_energy(c.s));
  }
  EXPECT_NEAR(most, 0.5 * stiffness * turned * turned, 1e-2 * most);
  expect_near(packing_of(c.s).grains.omega[0], {0.5 * turned * frequency, 0, 0}, 1e-2 * turned * frequency);
}

/// A packing that brings its bonds is strained as it was.
TEST(SphereBonds, ArePartOfAPacking) {
  Block c;
  advance(c.s, c.pool, 400);
  PackingIn<3> now = packing_of(c.s);
  const double held = bond_energy(c.s);
  now.contacts = {};
  Spheres next(1e6);
  next.start = now;
  next.contact = c.contact;
  const SampleIn<3> taken = next.sample();
  EXPECT_GT(held, 0);
  EXPECT_NEAR(bond_energy(taken), held, 1e-6 * held);
}

}  // namespace
}  // namespace arenite::verification
