#include "grains/fields/coarse_grained.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "grains/texture/texture.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::fields {
namespace {

using std::numbers::pi;

/// Grains that fly about in a periodic cell of 10 m x 8 m, with random forces where they overlap: large enough to weigh
/// as much in the balance of momentum as the flow does.
Packing gas(std::uint64_t seed, double tilt = 0, int grains = 60) {
  RandomStream random(seed, Purpose::test);
  Packing p = test::empty_box(10, 8, 0.06);
  p.domain.periodic[0] = p.domain.periodic[1] = true;
  p.domain.tilt = tilt;
  for (int g = 0; g < grains; ++g) {
    test::add_grain(p, {random.uniform(0, 10), random.uniform(0, 8)}, random.uniform(0.3, 0.6),
                    static_cast<int>(random.below(2)));
    p.grains.velocity.back() = {3 + random.normal(), random.normal()};
  }
  for (std::size_t i = 0; i < p.grains.size(); ++i)
    for (std::size_t j = i + 1; j < p.grains.size(); ++j)
      if (norm(p.domain.nearest_image(p.grains.position[i] - p.grains.position[j])) <
          p.grains.radius[i] + p.grains.radius[j])
        test::add_contact(p, i, j, -400 * std::log(1 - random.uniform()), random.uniform(-120, 120));
  return p;
}

double total(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum;
}
template <class T> std::vector<double> part(const std::vector<T>& values, double T::*member) {
  std::vector<double> out;
  for (const T& v : values) out.push_back(v.*member);
  return out;
}

struct Sums {
  double mass = 0, area = 0, moment_size = 0, momentum_size = 0;
  Vec2 momentum;
};
Sums sums_of(const Packing& p) {
  Sums s;
  for (std::size_t g = 0; g < p.grains.size(); ++g) {
    const double m = texture::mass_of(p, g);
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

/// Derivative along x or y of a periodic field whose shortest waves are empty, by its trigonometric interpolation:
/// exact to rounding.
std::vector<double> derivative(const Grid& grid, const std::vector<double>& f, bool along_x) {
  const int n = along_x ? grid.columns : grid.rows;  // even
  const double length = along_x ? grid.bounds.width() : grid.bounds.height();
  std::vector<double> out(f.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      for (int k = 0; k < n; ++k) {
        const int at = along_x ? column : row;
        if (k == at) continue;
        const double weight = pi / length * ((at - k) % 2 ? -1 : 1) / std::tan(pi * (at - k) / n);
        out[static_cast<std::size_t>(row * grid.columns + column)] +=
            weight * f[static_cast<std::size_t>(along_x ? row * grid.columns + k : k * grid.columns + column)];
      }
  return out;
}
std::vector<double> divergence(const Grid& grid, const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> sum = derivative(grid, x, true);
  const std::vector<double> other = derivative(grid, y, false);
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += other[k];
  return sum;
}
double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

/// drho/dt and dp/dt at a point as Newton's second law moves the grains.
struct Rates {
  double density = 0;
  Vec2 momentum;
};
Rates rates_at(const Packing& p, Vec2 point, double width) {
  std::vector<Vec2> force(p.grains.size());
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    force[static_cast<std::size_t>(p.contacts.i[c])] += p.contacts.force_on_i(c);
    force[static_cast<std::size_t>(p.contacts.j[c])] -= p.contacts.force_on_i(c);
  }
  Rates rates;
  for (std::size_t g = 0; g < p.grains.size(); ++g)
    for (int row = -1; row <= 1; ++row)
      for (int column = -1; column <= 1; ++column) {
        const Vec2 d = point - p.grains.position[g] - Vec2{10.0 * column, 8.0 * row}, v = p.grains.velocity[g];
        const double phi = std::exp(-dot(d, d) / (2 * width * width)) / (2 * pi * width * width) / p.domain.thickness;
        const double dphi = dot(v, d) / (width * width) * phi;  // of a kernel that moves at v
        rates.density += texture::mass_of(p, g) * dphi;
        rates.momentum += phi * force[g] + texture::mass_of(p, g) * dphi * v;
      }
  return rates;
}

TEST(CoarseGrained, ConservesMassAndMomentumAtEveryPoint) {
  // Width 0.8 = 3.2 h: waves of 2 h, the shortest that the grid knows, are exp(-(3.2 pi)^2/2) = 1e-22 of the longest,
  // so the derivative is exact but for rounding, 40 weights of up to n/2 each times 1e-16, and for images beyond the
  // nearest, exp(-(8/0.8)^2/2).
  const double width = 0.8;
  const Packing p = gas(7);
  const Grid grid = grid_over(p.domain, 0.25);
  const CoarseFields f = coarse_grain(p, grid, {KernelShape::gaussian, width, {}, {}});
  std::vector<Tensor2> flux = f.contact_stress;  // of momentum
  for (std::size_t k = 0; k < flux.size(); ++k) {
    flux[k] += f.kinetic_stress[k];
    flux[k] += f.gradient_stress[k];
    flux[k] += -f.density[k] * outer(f.velocity[k], f.velocity[k]);
  }
  const std::vector<double> outflow = divergence(grid, part(f.momentum, &Vec2::x), part(f.momentum, &Vec2::y));
  const std::vector<double> push_x = divergence(grid, part(flux, &Tensor2::xx), part(flux, &Tensor2::xy));
  const std::vector<double> push_y = divergence(grid, part(flux, &Tensor2::yx), part(flux, &Tensor2::yy));
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t k = static_cast<std::size_t>(row * grid.columns + column);
      const Rates rates = rates_at(p, grid.point(column, row), width);
      EXPECT_NEAR(rates.density + outflow[k], 0, 1e-12 * largest(outflow));
      EXPECT_NEAR(rates.momentum.x, push_x[k], 1e-12 * largest(push_x));
      EXPECT_NEAR(rates.momentum.y, push_y[k], 1e-12 * largest(push_y));
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

TEST(CoarseGrained, KineticStressIsThatOfTheFluctuationAboutTheLocalVelocity) {
  // Two grains of equal mass at the same distance from the point: V is their mean, from which each differs by (1, 2)
  // m/s; at a grain the other counts with the share of its kernel, so each fluctuates by 2 phi(2)/(phi(0) + phi(2)) of
  // that.
  Packing p = test::empty_box(10, 8, 0.06);
  test::add_grain(p, {4, 4}, 0.5);
  test::add_grain(p, {6, 4}, 0.5);
  p.grains.velocity = {{101, 2}, {99, -2}};
  const Grid middle{{4.5, 5.5, 3.5, 4.5}, 1, 1};
  const CoarseFields f = coarse_grain(p, middle, {KernelShape::lucy, 0.8, {}, {}});
  const Kernel kernel(KernelShape::lucy, 0.8);
  const double rho = 2 * 1000 * pi * 0.25 * kernel.value({1, 0}), far = kernel.value({2, 0});
  const double share = 2 * far / (kernel.value({}) + far), square = rho * share * share;
  EXPECT_NEAR(f.density[0], rho, 1e-13 * rho);
  EXPECT_NEAR(f.velocity[0].x, 100, 1e-12);
  EXPECT_NEAR(f.kinetic_stress[0].xx, -square, 1e-11 * rho);  // the velocity is rounded at 1e-14 of 100 m/s
  EXPECT_NEAR(f.kinetic_stress[0].xy, -2 * square, 1e-11 * rho);
  EXPECT_NEAR(f.kinetic_stress[0].yy, -4 * square, 1e-11 * rho);
  EXPECT_NEAR(f.kinetic_stress[0].xx + f.gradient_stress[0].xx, -rho, 1e-11 * rho);
}

TEST(CoarseGrained, KineticStressOfAShearWithoutFluctuationIsNoneWhateverTheWidth) {
  // A lattice under simple shear v_x = 0.3 y in a Lees-Edwards cell: V at a grain is its own velocity; about V(r) alone
  // there would be rho (0.3 w)^2.
  Packing p = test::square_lattice(12);
  for (std::size_t g = 0; g < p.grains.size(); ++g) p.grains.velocity[g].x = 0.3 * p.grains.position[g].y;
  for (const double width : {0.9, 1.5, 2.5}) {
    const CoarseFields f = coarse_grain(p, grid_over(p.domain, 1), {KernelShape::gaussian, width, {}, 0.3 * 12});
    EXPECT_LT(largest(part(f.kinetic_stress, &Tensor2::xx)), 1e-10 * f.density[0]) << width;
    EXPECT_NEAR(f.gradient_stress[0].xx, -f.density[0] * 0.09 * width * width,
                0.02 * f.density[0] * 0.09 * width * width)
        << width;
  }
}

TEST(CoarseGrained, ImagesMoveWithTheSidesOfTheCell) {
  // A lattice under simple shear v_x = 0.3 y in a Lees-Edwards cell 6 m high: at a grain, by symmetry, V is its own
  // velocity, in every row alike.
  Packing p = test::square_lattice(6);
  for (std::size_t g = 0; g < p.grains.size(); ++g) p.grains.velocity[g].x = 0.3 * p.grains.position[g].y;
  const CoarseFields f = coarse_grain(p, grid_over(p.domain, 1), {KernelShape::lucy, 0.9, {}, 0.3 * 6});
  for (std::size_t g = 0; g < p.grains.size(); ++g) {
    EXPECT_NEAR(f.velocity[g].x, p.grains.velocity[g].x, 1e-14);
    EXPECT_NEAR(f.density[g], f.density[0], 1e-11);  // of 1000 kg/m^3: the sums differ in their order only
    EXPECT_NEAR(f.kinetic_stress[g].xx, f.kinetic_stress[0].xx, 1e-11);
  }
  // The same for a cell that widens on both sides and is sheared already: v_x = 0.1 (x - 3), and the tilt follows.
  p = test::square_lattice(6);
  p.domain.tilt = 2;
  p.domain.wall[right].velocity = 0.3;
  p.domain.wall[left].velocity = -0.3;
  for (std::size_t g = 0; g < p.grains.size(); ++g) p.grains.velocity[g].x = 0.1 * (p.grains.position[g].x - 3);
  const CoarseFields wide = coarse_grain(p, grid_over(p.domain, 1), {KernelShape::lucy, 0.9, {}, {}});
  for (std::size_t g = 0; g < p.grains.size(); ++g) EXPECT_NEAR(wide.velocity[g].x, p.grains.velocity[g].x, 1e-14);
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
