#include "grains/fields/coarse_grained.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "grains/texture/texture.hpp"
#include "unit/grains/fields/gas.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::fields {
namespace {

struct Sums {
  double mass = 0, area = 0, moment_size = 0, momentum_size = 0;
  Vec2 momentum;
};
Sums sums_of(const Packing& p) {
  Sums s;
  for (std::size_t g = 0; g < p.grains.size(); ++g) {
    const double m = mass_of(p, g);
    const Vec2 v = p.grains.velocity[g];
    s.mass += m;
    s.area += pi * p.grains.radius[g] * p.grains.radius[g];
    s.momentum += m * v;
    s.momentum_size += m * norm(v);
  }
  for (std::size_t c = 0; c < p.contacts.size(); ++c)
    s.moment_size += norm(p.contacts.force_on_i(c)) * (p.contacts.arm_i[c] + p.contacts.arm_j[c]);
  return s;
}

/// Largest relative difference between grid sums and what they must be.
double worst_integral(const Packing& p, const CoarseFields& f) {
  const double volume = f.grid.cell_area() * p.domain.thickness;
  const Sums s = sums_of(p);
  Tensor2 moment;
  for (std::size_t c = 0; c < p.contacts.size(); ++c) moment += outer(p.contacts.force_on_i(c), p.contacts.branch(c));
  double worst = 0;
  const auto compare = [&](double found, double wanted, double size) {
    worst = std::max(worst, std::abs(found - wanted) / size);
  };
  compare(total(f.density) * volume, s.mass, s.mass);
  compare(total(f.solid_fraction) * f.grid.cell_area(), s.area, s.area);
  compare(total(part(f.momentum, &Vec2::x)) * volume, s.momentum.x, s.momentum_size);
  compare(total(part(f.momentum, &Vec2::y)) * volume, s.momentum.y, s.momentum_size);
  for (const auto member : {&Tensor2::xx, &Tensor2::xy, &Tensor2::yx, &Tensor2::yy})
    compare(total(part(f.contact_stress, member)) * volume, moment.*member, s.moment_size);
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

TEST(CoarseGrained, BalancesForcesByTheContactStressAlone) {
  // div of the contact stress = sum f_i phi(r - r_i)/L; grains at rest have no other terms.
  Packing p = gas(8);
  for (std::size_t g = 0; g < p.grains.size(); ++g) p.grains.velocity[g].x = p.grains.velocity[g].y = 0;
  const Grid grid = grid_over(p.domain, 0.25);
  const CoarseFields f = coarse_grain(p, grid, {KernelShape::gaussian, 0.8, {}, {}});
  const std::vector<double> push =
      divergence(grid, part(f.contact_stress, &Tensor2::xx), part(f.contact_stress, &Tensor2::xy));
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      EXPECT_NEAR(push[static_cast<std::size_t>(row * grid.columns + column)],
                  rates_at(p, grid.point(column, row), 0.8).momentum.x, 1e-12 * largest(push));
  EXPECT_EQ(largest(part(f.kinetic_stress, &Tensor2::xx)), 0);
}

TEST(CoarseGrained, HasTheGradientOfItsVelocity) {
  // V is no band-limited field, so the gradient is that of a difference over a step e = 1e-4 w: e^2 of a third
  // derivative, 1e-8, and rounding 1e-12.
  const Packing p = gas(9, 1.3);
  for (const KernelShape shape : {KernelShape::gaussian, KernelShape::lucy}) {
    const CoarseGraining choice{shape, 1, {}, {}};
    const auto at = [&](double x, double y) { return coarse_grain(p, {{x - 1, x + 1, y - 1, y + 1}, 1, 1}, choice); };
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
  const CoarseFields at = coarse_grain(p, {{0.9, 1.1, 0.05, 0.15}, 1, 1}, {KernelShape::lucy, 0.1, {}, {}});
  // f = 7 N up and, with t = n turned = -x, 2 N to the left; l = (0, -0.3) m. The point (1, 0.1) lies on the branch.
  const double mean = kernel.line_mean({0, -0.2}, {0, 0.1}) / 0.5;
  EXPECT_NEAR(at.contact_stress[0].yy, -7 * 0.3 * mean, 1e-13 * 7 * mean);
  EXPECT_NEAR(at.contact_stress[0].xy, 2 * 0.3 * mean, 1e-13 * 7 * mean);
  EXPECT_NEAR(at.wall_force[0].y, 7 * kernel.value({0, 0.1}) / 0.5, 1e-11);
  // The whole force, if the grid reaches as far below the floor as the kernel (Lucy's sum as above, c = 13 steps).
  const Grid around{{0, 2, -1, 1}, 80, 80};
  const CoarseFields f = coarse_grain(p, around, {KernelShape::lucy, 0.1, {}, {}});
  EXPECT_NEAR(total(part(f.wall_force, &Vec2::y)) * around.cell_area() * 0.5, 7, 7 * 4e-7);
  EXPECT_NEAR(total(part(f.wall_force, &Vec2::x)) * around.cell_area() * 0.5, -2, 2 * 4e-7);
  EXPECT_TRUE(std::isnan(f.velocity[0].x));  // no grain in reach of a corner
  EXPECT_EQ(f.density[0], 0);
}

TEST(CoarseGrained, RefusesWhatHasNoVolume) {
  Packing p = gas(1);
  EXPECT_THROW(grid_over(p.domain, 0), InputError);
  EXPECT_THROW(coarse_grain(p, grid_over(p.domain, 1), {KernelShape::lucy, 0, {}, {}}), InputError);
  EXPECT_THROW(coarse_grain(p, {{0, 1, 0, 1}, 0, 3}, {KernelShape::lucy, 1, {}, {}}), InputError);
  p.domain.thickness = 0;
  EXPECT_THROW(coarse_grain(p, grid_over(p.domain, 1), {KernelShape::lucy, 1, {}, {}}), InputError);
  EXPECT_EQ(grid_over(p.domain, 0.1).columns, 100);
}

}  // namespace
}  // namespace arenite::fields
