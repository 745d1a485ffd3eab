#include <gtest/gtest.h>

#include "geometry/rim.hpp"
#include "shapes.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;

/// Some tens of clumps on a lattice at many angles, moving about.
Packing crowd(bool periodic, std::uint64_t seed = 1, int side = 6) {
  const double pitch = 0.0185;
  Packing p = periodic ? periodic_cell(side * pitch, side * pitch) : box(side * pitch, side * pitch);
  RandomStream random(seed, Purpose::test);
  for (int q = 0; q < side * side; ++q) {
    const Vec2 at{(q % side + 0.5) * pitch, (q / side + 0.5) * pitch};
    add(p, Clump{q % 3 == 0 ? dumbbell : bent,
                 at,
                 5e-3,
                 random.uniform(0, 6),
                 {random.uniform(-1, 1), random.uniform(-1, 1)},
                 random.uniform(-50, 50)});
  }
  return p;
}

Packing pressed_clumps(bool periodic, int side = 6) { return pressed_together(crowd(periodic, 1, side), side); }

TEST(Clumps, EnergyIsClosedToAMillionthOfTheWorkAtAStepOfTcOver500) { expect_energy_is_closed(pressed_clumps); }

TEST(Clumps, SameBitsOnOneAndTwoThreadsAndForEveryKernel) { expect_same_bits(pressed_clumps(true, 48)); }

TEST(Clumps, AStateThatIsSavedAndRestoredGoesOnWithTheSameBits) {
  const Packing p = crowd(true, 5);
  Engine whole(p, {}, {});
  set_shear_rate(whole, 20);
  whole.advance(1733);
  const auto bytes = save_sample(whole);
  whole.advance(2000);
  Engine resumed(p, {}, {});
  restore_sample(resumed, bytes);
  resumed.advance(2000);
  EXPECT_GT(whole.builds, 3);
  EXPECT_EQ(state_hash(resumed), state_hash(whole));
}

TEST(Clumps, DisksAmongThemTouchAtTheirOwnCentresArms) {
  Packing p = crowd(true, 5);
  for (int q = 0; q < 36; ++q) add(p, Clump{{{0, 0}}, {(q % 6 + 1) * 0.0185, (q / 6 + 1) * 0.0185}, 4e-3, 0, {9, -7}});
  Engine engine(p, {}, {});
  set_drives(engine, {moved(2), moved(-2), moved(2), moved(-2)});
  while (packing_of(engine).contacts.size() < 150) engine.advance(50);
  set_drives(engine, {});
  set_shear_rate(engine, 100);
  std::size_t disks = 0;
  for (int k = 0; k < 20; ++k) {
    engine.advance(200);
    Engine again(p, {}, {});
    restore_sample(again, save_sample(engine));
    for (const Packing& now : {packing_of(engine), packing_of(again)})
      for (std::size_t c = 0; c < now.contacts.size(); ++c) {
        if (now.contacts.j[c] < 36) continue;
        ++disks;
        EXPECT_NEAR(now.contacts.off_j[c].x, 0, 1e-15) << c;
        EXPECT_NEAR(now.contacts.off_j[c].y, 0, 1e-15) << c;
      }
  }
  EXPECT_GT(engine.builds, 20);
  EXPECT_GT(disks, 100U);
}

/// The force on a clump is minus the slope of the elastic energy: without friction and dashpots, against moving it by
/// hand.
TEST(Clumps, ForceIsMinusTheGradientOfTheEnergy) {
  dem::ContactParameters law;
  law.friction = 0;
  law.restitution = 1;
  dem::IntegrationParameters how;
  how.safety = 1e-4;
  Packing p = box(1, 1);
  add(p, Clump{bent, {0.3, 0.4}, 6.2e-3, 0.4});
  add(p, Clump{dumbbell, {0.311, 0.4052}, 6.2e-3, -1});
  const double mass_of_one = mass(p, 0), inertia = mass_of_one * std::pow(p.grains.shapes.gyration[0], 2);
  const auto energy = [&](double dx, double dy, double turn) {
    Packing moved = p;
    moved.grains.position[0].x += dx;
    moved.grains.position[0].y += dy;
    moved.grains.angle[0] += turn;
    return energies_of(Engine(moved, law, how)).elastic;
  };
  ASSERT_GT(energy(0, 0, 0), 0);
  Engine engine(p, law, how);
  const double dt = engine.dt;
  engine.advance(1);
  set_gravity(engine, {1e-30, 0});  // brings velocities to the time of the places
  const Packing end = packing_of(engine);
  const double h = 1e-8;
  const Vec2 force{-(energy(h, 0, 0) - energy(-h, 0, 0)) / (2 * h), -(energy(0, h, 0) - energy(0, -h, 0)) / (2 * h)};
  const double turn = h / 6.2e-3, torque = -(energy(0, 0, turn) - energy(0, 0, -turn)) / (2 * turn);
  EXPECT_NEAR(mass_of_one * end.grains.velocity[0].x / dt, force.x, 1e-5 * norm(force));
  EXPECT_NEAR(mass_of_one * end.grains.velocity[0].y / dt, force.y, 1e-5 * norm(force));
  EXPECT_NEAR(inertia * end.grains.omega[0] / dt, torque, 1e-5 * std::abs(torque));
}

}  // namespace
}  // namespace arenite::verification
