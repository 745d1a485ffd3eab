#include "grains/fields/coarse_grained.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "grains/texture/texture.hpp"
#include "unit/grains/fields/gas.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::fields {
namespace {

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

}  // namespace
}  // namespace arenite::fields
