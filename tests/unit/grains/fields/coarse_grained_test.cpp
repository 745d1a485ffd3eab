#include "grains/fields/coarse_grained.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "grains/texture/texture.hpp"
#include "unit/grains/fields/gas.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::fields {
namespace {

/// Largest relative difference between grid sums and what they must be.
template <int D> double worst_integral(const PackingIn<D>& p, const CoarseFieldsIn<D>& f) {
  const double volume = f.grid.cell_volume() * length_of(p);
  double mass = 0, solid = 0, momentum_size = 0, moment_size = 0, worst = 0;
  Vec<D> momentum;
  Tensor<D> moment;
  for (std::size_t g = 0; g < p.grains.size(); ++g) {
    const double m = mass_of(p, g), r = p.grains.radius[g];
    mass += m;
    solid += D == 2 ? pi * r * r : 4.0 / 3 * pi * r * r * r;
    momentum += m * p.grains.velocity[g];
    momentum_size += m * norm(p.grains.velocity[g]);
  }
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    moment += dyad(p.contacts.force_on_i(c), p.contacts.branch(c));
    moment_size += norm(p.contacts.force_on_i(c)) * (p.contacts.arm_i[c] + p.contacts.arm_j[c]);
  }
  const auto compare = [&](double found, double wanted, double size) {
    worst = std::max(worst, std::abs(found - wanted) / size);
  };
  compare(total(f.density) * volume, mass, mass);
  compare(total(f.solid_fraction) * f.grid.cell_volume(), solid, solid);
  for (int a = 0; a < D; ++a) {
    compare(total(along(f.momentum, a)) * volume, momentum[a], momentum_size);
    for (int b = 0; b < D; ++b)
      compare(total(components(f.contact_stress, a, b)) * volume, component(moment, a, b), moment_size);
  }
  return worst;
}

TEST(CoarseGrained, IntegratesOverAPeriodicCellToMassMomentumAndLoveWeberSum) {
  // The sum over a grid of steps h differs from the integral by the Fourier components of wavelength h and less. Of a
  // Gaussian of width 1.6 h they are exp(-2 (1.6 pi)^2) = 1e-22: what is left is rounding of some thousand terms and
  // the tail cut at 2e-16.
  for (const double tilt : {0.0, 2.7, -13.0}) {
    const Packing p = gas(3, tilt);
    EXPECT_LT(worst_integral(p, coarse_grain(p, grid_over(p.domain, 0.25), {KernelShape::gaussian, 0.4, {}, {}})),
              1e-12)
        << tilt;
    EXPECT_LT(worst_integral(p, coarse_grain(p, grid_over(p.domain, 0.5), {KernelShape::gaussian, 5, {}, {}})), 1e-12)
        << tilt;
    // Lucy's components fall as 1/k^4.5 only, from 1 at k c = 1: at k = 2 pi/h with c = 13.4 h that is 84^-4.5 = 2e-9
    // times its numerical factor (at the rim 5/pi 6 times 2 pi sqrt(2/pi) = 48, in each of 4 directions).
    EXPECT_LT(worst_integral(p, coarse_grain(p, grid_over(p.domain, 0.25), {KernelShape::lucy, 1, {}, {}})), 4e-7)
        << tilt;
  }
}

TEST(CoarseGrained, OfSpheresIntegratesToMassMomentumAndLoveWeberSum) {
  // As in the plane; of Lucy's function 630/(k c)^5 with k c = 2 pi/h 3.46 = 54 in each of six directions, 8e-6, half
  // of that by waves askew.
  for (const double tilt : {0.0, 2.7, -13.0}) {
    const PackingIn<3> p = gas_in_space(3, tilt);
    ASSERT_GT(p.contacts.size(), 20u);
    EXPECT_LT(worst_integral(p, coarse_grain(p, grid_over(p.domain, 0.5), {KernelShape::gaussian, 0.8, {}, {}})), 1e-12)
        << tilt;
    EXPECT_LT(worst_integral(p, coarse_grain(p, grid_over(p.domain, 0.4), {KernelShape::lucy, 1, {}, {}})), 1.3e-5)
        << tilt;
  }
}

TEST(CoarseGrained, BondsAndPullsAcrossGapsBearAsContactsDo) {
  // Pulled with 5 and 3 N along x, and no contact: the Love-Weber sum is theirs.
  Packing p = gas(4);
  p.contacts = {};
  p.grains.position[0] = {1, 2}, p.grains.position[1] = {1.9, 2}, p.grains.position[2] = {2.9, 2};
  p.bonds = {{}};
  p.bonds[0].i = 0, p.bonds[0].j = 1;
  p.bonds[0].fn = -5;
  p.cohesive = {{1, 2, 0.1, 3}, {0, 2, -0.1, 7}};  // the pull of grains that touch is in the force of their contact
  const CoarseFields f = coarse_grain(p, grid_over(p.domain, 0.25), {KernelShape::gaussian, 0.8, {}, {}});
  const double volume = f.grid.cell_volume() * p.domain.thickness;
  EXPECT_NEAR(total(components(f.contact_stress, 0, 0)) * volume, 5 * 0.9 + 3 * 1.0, 1e-11);
  EXPECT_NEAR(total(components(f.contact_stress, 1, 1)), 0, 1e-11);
}

TEST(CoarseGrained, BondsOfSpheresBearAsContactsDo) {
  // A bond that is pulled with 5 N over 1.2 m across a periodic side, and no contact: the Love-Weber sum is its own.
  PackingIn<3> p = gas_in_space(4, 0, 2);
  p.contacts = {};
  p.grains.position = {{0.3, 4, 4}, {7.1, 4, 4}};
  p.bonds = {{}};
  p.bonds[0].i = 0, p.bonds[0].j = 1;
  p.bonds[0].fn = -5;
  const CoarseFieldsIn<3> f = coarse_grain(p, grid_over(p.domain, 0.5), {KernelShape::gaussian, 0.8, {}, {}});
  EXPECT_NEAR(total(components(f.contact_stress, 0, 0)) * f.grid.cell_volume(), 5 * 1.2, 1e-11);
  EXPECT_NEAR(total(components(f.contact_stress, 1, 1)), 0, 1e-11);
}

TEST(CoarseGrained, TheSolidFractionOfALatticeIsItsOwn) {
  // Spheres of 0.5 m, one a cubic metre; waves of the lattice are exp(-(2 pi 1.5)^2/2) = 5e-20 of the mean.
  PackingIn<3> p = gas_in_space(5, 0, 512);
  for (std::size_t g = 0; g < 512; ++g) {
    const auto at = [&](std::size_t over) { return static_cast<double>(g / over % 8); };
    p.grains.position[g] = {at(1), at(8), at(64)};
    p.grains.radius[g] = 0.5;
  }
  p.contacts = {};
  const CoarseFieldsIn<3> f = coarse_grain(p, grid_over(p.domain, 1.9), {KernelShape::gaussian, 1.5, {}, {}});
  for (const double fraction : f.solid_fraction) EXPECT_NEAR(fraction, pi / 6, 1e-13);
}

TEST(CoarseGrained, BalancesForcesByTheContactStressAlone) {
  // div of the contact stress = sum f_i phi(r - r_i)/L; grains at rest have no other terms.
  Packing p = gas(8);
  for (std::size_t g = 0; g < p.grains.size(); ++g) p.grains.velocity[g].x = p.grains.velocity[g].y = 0;
  const Grid grid = grid_over(p.domain, 0.25);
  const CoarseFields f = coarse_grain(p, grid, {KernelShape::gaussian, 0.8, {}, {}});
  const std::vector<double> push = divergence(grid, f.contact_stress, 0);
  for_every_point(grid, [&](const Cells<2>& at) {
    EXPECT_NEAR(push[grid.index(at)], rates_at(p, grid.point(at), 0.8).momentum.x, 1e-12 * largest(push));
  });
  EXPECT_EQ(largest(part(f.kinetic_stress, &Tensor2::xx)), 0);
}

TEST(CoarseGrained, HasTheGradientOfItsVelocity) {
  // V is no band-limited field, so the gradient is that of a difference over a step e = 1e-4 w: e^2 of a third
  // derivative, 1e-8, and rounding 1e-12.
  const Packing p = gas(9, 1.3);
  for (const KernelShape shape : {KernelShape::gaussian, KernelShape::lucy}) {
    const CoarseGraining choice{shape, 1, {}, {}};
    const auto at = [&](double x, double y) {
      return coarse_grain(p, {{x - 1, y - 1}, {x + 1, y + 1}, {1, 1}}, choice);
    };
    const double e = 1e-4;
    for (const Vec2 r : {Vec2{1, 1}, Vec2{5.3, 7.9}, Vec2{9.9, 0.1}}) {
      const Tensor2 g = at(r.x, r.y).velocity_gradient[0];
      const Vec2 dx = (at(r.x + e, r.y).velocity[0] - at(r.x - e, r.y).velocity[0]) / (2 * e);
      const Vec2 dy = (at(r.x, r.y + e).velocity[0] - at(r.x, r.y - e).velocity[0]) / (2 * e);
      EXPECT_NEAR(g.xx, dx.x, 1e-6);
      EXPECT_NEAR(g.yx, dx.y, 1e-6);
      EXPECT_NEAR(g.xy, dy.x, 1e-6);
      EXPECT_NEAR(g.yy, dy.y, 1e-6);
    }
  }
}

TEST(CoarseGrained, KnowsWallsByTheirForceOnTheGrains) {
  // A grain on the floor: stress along the line from its centre to the floor, and a force density around the point of
  // contact.
  Packing p = test::empty_box(2, 2, 0.5);
  test::add_grain(p, {1, 0.3}, 0.3);
  test::add_wall_contact(p, 0, bottom, 7, 2);
  const Kernel kernel(KernelShape::lucy, 0.1);
  const CoarseFields at = coarse_grain(p, {{0.9, 0.05}, {1.1, 0.15}, {1, 1}}, {KernelShape::lucy, 0.1, {}, {}});
  // f = 7 N up and, with t = n turned = -x, 2 N to the left; l = (0, -0.3) m. The point (1, 0.1) lies on the branch.
  const double mean = kernel.line_mean({0, -0.2}, Kernel::Line({0, 0.3})) / 0.5;
  EXPECT_NEAR(at.contact_stress[0].yy, -7 * 0.3 * mean, 1e-13 * 7 * mean);
  EXPECT_NEAR(at.contact_stress[0].xy, 2 * 0.3 * mean, 1e-13 * 7 * mean);
  EXPECT_NEAR(at.wall_force[0].y, 7 * kernel.value({0, 0.1}) / 0.5, 1e-11);
  // The whole force, if the grid reaches as far below the floor as the kernel (Lucy's sum as above, c = 13 steps).
  const Grid around{{0, -1}, {2, 1}, {80, 80}};
  const CoarseFields f = coarse_grain(p, around, {KernelShape::lucy, 0.1, {}, {}});
  EXPECT_NEAR(total(part(f.wall_force, &Vec2::y)) * around.cell_volume() * 0.5, 7, 7 * 4e-7);
  EXPECT_NEAR(total(part(f.wall_force, &Vec2::x)) * around.cell_volume() * 0.5, -2, 2 * 4e-7);
  EXPECT_TRUE(std::isnan(f.velocity[0].x));  // no grain in reach of a corner
  EXPECT_EQ(f.density[0], 0);
}

TEST(CoarseGrained, KnowsTheFloorByItsForceOnASphere) {
  // As in the plane: f = 7 N up and, with ft x n, 2 N along x; l = (0, -0.3, 0) m. The first point lies on the branch.
  PackingIn<3> p;
  p.materials = {{"A", 1000, 0, 0}};
  for (const int side : {right, top, front}) p.domain.wall[side].position = 2;
  p.grains.resize(1);
  p.grains.position = {{1, 0.3, 1}};
  p.grains.radius = {0.3};
  p.contacts.add(0, wall_partner(bottom), {0, 1, 0}, 7, {0, 0, -2}, 0.3, 0);
  ASSERT_EQ(p.contacts.force_on_i(0), (Vec3{2, 7, 0}));
  const KernelIn<3> kernel(KernelShape::lucy, 0.1);
  const auto on = [&](const GridIn<3>& grid) { return coarse_grain(p, grid, {KernelShape::lucy, 0.1, {}, {}}); };
  const CoarseFieldsIn<3> at = on({{0.9, 0.05, 0.9}, {1.1, 0.15, 1.1}, {1, 1, 1}});
  const double mean = kernel.line_mean({0, -0.2, 0}, KernelIn<3>::Line({0, 0.3, 0}));
  EXPECT_NEAR(at.contact_stress[0].at[1][1], -7 * 0.3 * mean, 1e-13 * 7 * mean);
  EXPECT_NEAR(at.contact_stress[0].at[0][1], -2 * 0.3 * mean, 1e-13 * 7 * mean);
  EXPECT_NEAR(at.wall_force[0].y, 7 * kernel.value({0, 0.1, 0}), 1e-11 * 7 * mean);
  // The whole force, if the grid reaches as far below the floor as the kernel (c = 8.7 steps: as above).
  const GridIn<3> around{{0.5, -0.5, 0.5}, {1.5, 0.5, 1.5}, {25, 25, 25}};
  const CoarseFieldsIn<3> f = on(around);
  EXPECT_NEAR(total(along(f.wall_force, 1)) * around.cell_volume(), 7, 7 * 1.3e-5);
  EXPECT_NEAR(total(along(f.wall_force, 0)) * around.cell_volume(), 2, 7 * 1.3e-5);
  EXPECT_TRUE(std::isnan(f.velocity[0].z) && std::isnan(f.velocity_gradient[0].at[2][1]));  // no grain in reach
}

TEST(CoarseGrained, RefusesWhatHasNoVolume) {
  Packing p = gas(1);
  EXPECT_THROW(grid_over(p.domain, 0), InputError);
  EXPECT_THROW(coarse_grain(p, grid_over(p.domain, 1), {KernelShape::lucy, 0, {}, {}}), InputError);
  EXPECT_THROW(coarse_grain(p, {{0, 0}, {1, 1}, {0, 3}}, {KernelShape::lucy, 1, {}, {}}), InputError);
  p.domain.thickness = 0;
  EXPECT_THROW(coarse_grain(p, grid_over(p.domain, 1), {KernelShape::lucy, 1, {}, {}}), InputError);
  EXPECT_EQ(grid_over(p.domain, 0.1).count.x, 100);
}

}  // namespace
}  // namespace arenite::fields
