#include <gtest/gtest.h>

#include <cmath>

#include "grains/texture/texture.hpp"
#include "support.hpp"
#include "support/numbers_of.hpp"

namespace arenite::verification {
namespace {

using dem::Engine;

constexpr double grain_radius = 5e-3, modulus = 2e9;

dem::ContactParameters cemented(double damping, double strength = 1e30) {
  dem::ContactParameters contact = frictionless(0.5);
  dem::ParallelBond bond;
  bond.modulus = modulus;
  bond.damping = damping;
  bond.tensile_strength = bond.cohesion = strength;
  contact.bonds = bond;
  return contact;
}

/// A triangular lattice of touching disks, across both edges of its cell.
Packing lattice(int columns, int rows) {
  Packing p = periodic_cell(2 * grain_radius * columns, 2 * grain_radius * std::sqrt(0.75) * rows);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      add(p, {{2 * grain_radius * (c + 0.25 + 0.5 * (r % 2)), 2 * grain_radius * std::sqrt(0.75) * (r + 0.5)},
              grain_radius});
  return p;
}

TEST(BondedCell, LatticeIsAsStiffAsItsBonds) {
  // Pulled along y: sigma_yy = sqrt(3)/4 (3 k_n + k_s) e/t, sigma_xx = sqrt(3)/4 (k_n - k_s) e/t, with k_n = E t (l = 2
  // R) and k_s = k_n/2.5.
  const Packing start = lattice(8, 8);
  Engine engine(start, cemented(0.3), {});
  make_bonds(engine);
  ASSERT_EQ(count_bonds(engine).intact, 3u * 64);
  const double speed = 0.01;
  set_drives(engine, {dem::WallDrive{}, {}, {}, moved(speed)});
  while (time_of(engine) < 1e-3) engine.advance(10);
  set_drives(engine, {});
  engine.advance(20000);
  const Domain& cell = engine.domain;
  const double strain = (cell.height() - start.domain.height()) / start.domain.height(),
               unit = std::sqrt(3) / 4 * modulus * strain;
  const double yy = -cell.wall[top].force / (cell.width() * cell.thickness),
               xx = -cell.wall[right].force / (cell.height() * cell.thickness);
  EXPECT_GT(strain, 5e-5);
  EXPECT_NEAR(yy, unit * (3 + 0.4), 2 * strain * yy);
  EXPECT_NEAR(xx, unit * (1 - 0.4), 10 * strain * yy);
  const Packing end = packing_of(engine);
  const texture::Texture t = texture::measure(end);
  EXPECT_NEAR(test::tensor_of(t.numbers, "stress").yy, yy, 1e-9 * yy);
  EXPECT_NEAR(test::tensor_of(t.numbers, "stress").xx, xx, 1e-9 * yy);
  EXPECT_NEAR(test::tensor_of(t.numbers, "stress_details/sum_over_grains").yy, yy, 1e-9 * yy);
}

TEST(BondedCell, EnergyIsClosedWhileItIsShearedAndPressedToPieces) {
  for (const double strength : {1e30, 3e6}) {
    dem::IntegrationParameters how = with_step(shortest_contact_time() / 500);
    how.track_energy = true;
    Engine engine(lattice(8, 8), cemented(0.2, strength), how);
    make_bonds(engine);
    set_drives(engine, {dem::WallDrive{}, {}, {}, moved(-0.3)});
    set_shear_rate(engine, 50);
    const auto imbalance = [](const Energies& e) {
      return e.kinetic + e.elastic + e.dissipated_normal + e.dissipated_friction + e.dissipated_drag +
             e.dissipated_breakage - e.work_walls;
    };
    const Energies before = energies_of(engine);
    engine.advance(15000);
    const Energies after = energies_of(engine);
    EXPECT_EQ(count_bonds(engine).intact < count_bonds(engine).made(), strength < 1e10);
    EXPECT_GT(after.dissipated_normal, 1e-3 * after.work_walls);
    EXPECT_LT(std::abs(imbalance(after) - imbalance(before)), 2e-6 * after.work_walls) << strength;
  }
}

TEST(BondedCell, BondsAcrossTheEdgesHoldHoweverFarTheCellIsSheared) {
  // Turned and carried round by the flow, a pair keeps together and to its length.
  Packing p = periodic_cell(0.2, 0.2);
  add(p, {{0.001, 0.15}, grain_radius});
  add(p, {{0.001 - 2 * grain_radius + 0.2, 0.15}, grain_radius});
  Engine engine(p, cemented(0.2), {});
  make_bonds(engine);
  ASSERT_EQ(count_bonds(engine).intact, 1u);
  set_shear_rate(engine, 40);
  while (engine.sheared < 20) engine.advance(1000);
  const Packing end = packing_of(engine);
  EXPECT_NEAR(norm(branch_of(end, end.bonds[0])), 2 * grain_radius, 1e-3 * grain_radius);
}

}  // namespace
}  // namespace arenite::verification
