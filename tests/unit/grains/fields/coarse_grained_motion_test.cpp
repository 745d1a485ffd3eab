#include "grains/fields/coarse_grained.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "grains/texture/texture.hpp"
#include "unit/grains/fields/gas.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::fields {
namespace {

/// At every so many points: the largest difference to Newton's law, of each balance over its largest term.
template <int D> double imbalance(const PackingIn<D>& p, const CoarseFieldsIn<D>& f, double width, std::size_t every) {
  std::vector<Tensor<D>> flux = f.contact_stress;  // of momentum
  for (std::size_t k = 0; k < flux.size(); ++k) {
    flux[k] += f.kinetic_stress[k];
    flux[k] += f.gradient_stress[k];
    flux[k] += -f.density[k] * dyad(f.velocity[k], f.velocity[k]);
  }
  const std::vector<double> outflow = divergence(f.grid, f.momentum);
  std::array<std::vector<double>, D> push;
  for (int axis = 0; axis < D; ++axis) push[static_cast<std::size_t>(axis)] = divergence(f.grid, flux, axis);
  double worst = 0;
  for_every_point(f.grid, [&](const Cells<D>& at) {
    const std::size_t k = f.grid.index(at);
    if (k % every != 0) return;
    const Rates<D> rates = rates_at(p, f.grid.point(at), width);
    worst = std::max(worst, std::abs(rates.density + outflow[k]) / largest(outflow));
    for (int axis = 0; axis < D; ++axis) {
      const auto& of = push[static_cast<std::size_t>(axis)];
      worst = std::max(worst, std::abs(rates.momentum[axis] - of[k]) / largest(of));
    }
  });
  return worst;
}

TEST(CoarseGrained, ConservesMassAndMomentumAtEveryPoint) {
  // Width 0.8 = 3.2 h: waves of 2 h, the shortest that the grid knows, are exp(-(3.2 pi)^2/2) = 1e-22 of the longest,
  // so the derivative is exact but for rounding, 40 weights of up to n/2 each times 1e-16, and for images beyond the
  // nearest, exp(-(8/0.8)^2/2).
  const Packing p = gas(7);
  const CoarseFields f = coarse_grain(p, grid_over(p.domain, 0.25), {KernelShape::gaussian, 0.8, {}, {}});
  EXPECT_LT(imbalance(p, f, 0.8, 1), 1e-12);
}

TEST(CoarseGrained, ConservesMassAndMomentumInSpace) {
  // Width 1 = 2.5 h: waves of 2 h are exp(-(2.5 pi)^2/2) = 4e-14 of the longest, images beyond the nearest
  // exp(-(8/1)^2/2) = 1e-14; the flux has hundreds of such terms.
  const PackingIn<3> p = gas_in_space(7);
  const CoarseFieldsIn<3> f = coarse_grain(p, grid_over(p.domain, 0.4), {KernelShape::gaussian, 1, {}, {}});
  EXPECT_LT(imbalance(p, f, 1, 53), 1e-10);
}

TEST(CoarseGrained, KineticStressIsThatOfTheFluctuationAboutTheLocalVelocity) {
  // Two grains of equal mass at the same distance from the point: V is their mean, from which each differs by (1, 2)
  // m/s; at a grain the other counts with the share of its kernel, so each fluctuates by 2 phi(2)/(phi(0) + phi(2)) of
  // that.
  Packing p = test::empty_box(10, 8, 0.06);
  test::add_grain(p, {4, 4}, 0.5);
  test::add_grain(p, {6, 4}, 0.5);
  p.grains.velocity = {{101, 2}, {99, -2}};
  const Grid middle{{4.5, 3.5}, {5.5, 4.5}, {1, 1}};
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

TEST(CoarseGrained, TwoSpheresFluctuateAboutTheirMean) {
  // As two disks do, by the kernel of space.
  PackingIn<3> p;
  p.materials = {{"A", 1000, 0, 0}};
  for (const int side : {right, top, front}) p.domain.wall[side].position = 10;
  p.grains.resize(2);
  p.grains.position = {{4, 4, 4}, {6, 4, 4}};
  p.grains.radius = {0.5, 0.5};
  p.grains.velocity = {{101, 2, -3}, {99, -2, 3}};
  const CoarseFieldsIn<3> f =
      coarse_grain(p, {{4.5, 3.5, 3.5}, {5.5, 4.5, 4.5}, {1, 1, 1}}, {KernelShape::lucy, 0.8, {}, {}});
  const KernelIn<3> kernel(KernelShape::lucy, 0.8);
  const double rho = 2 * 1000 * (4.0 / 3 * pi / 8) * kernel.value({1, 0, 0}), far = kernel.value({2, 0, 0});
  const double share = 2 * far / (kernel.value({}) + far), square = rho * share * share;
  EXPECT_NEAR(f.density[0], rho, 1e-13 * rho);
  EXPECT_NEAR(f.solid_fraction[0], rho / 1000, 1e-13);
  EXPECT_NEAR(f.velocity[0].x, 100, 1e-12);
  const Vec3 own{1, 2, -3};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const double of = -own[a] * own[b];
      EXPECT_NEAR(f.kinetic_stress[0].at[a][b], square * of, 1e-11 * rho);
      EXPECT_NEAR(f.kinetic_stress[0].at[a][b] + f.gradient_stress[0].at[a][b], rho * of, 1e-11 * rho);
    }
}

TEST(CoarseGrained, ImagesOfSpheresMoveWithTheTiltOfTheCell) {
  // A cubic lattice under simple shear v_x = 0.3 y in a cell of 4 m: at a grain, by symmetry, V is its own velocity.
  PackingIn<3> p;
  p.materials = {{"A", 1000, 0, 0}};
  p.domain.periodic = {true, true, true};
  for (int side = 0; side < 6; ++side) p.domain.wall[side] = {false, side % 2 == 0 ? 0.0 : 4.0};
  p.grains.resize(64);
  for (std::size_t g = 0; g < 64; ++g) {
    const auto at = [&](std::size_t over) { return static_cast<double>(g / over % 4) + 0.5; };
    p.grains.position[g] = {at(1), at(4), at(16)};
    p.grains.radius[g] = 0.5;
    p.grains.velocity[g].x = 0.3 * p.grains.position[g].y;
  }
  const CoarseFieldsIn<3> f = coarse_grain(p, grid_over(p.domain, 1), {KernelShape::lucy, 0.9, {}, 0.3 * 4});
  for (std::size_t g = 0; g < 64; ++g) {
    EXPECT_NEAR(f.velocity[g].x, p.grains.velocity[g].x, 1e-14);
    EXPECT_NEAR(f.density[g], f.density[0], 1e-11);
    // The rate that the lattice moves at, which points between its rows have on the mean only.
    EXPECT_NEAR(f.velocity_gradient[g].at[0][1], f.velocity_gradient[0].at[0][1], 1e-12);
    EXPECT_NEAR(f.velocity_gradient[g].at[0][1], 0.3, 0.03);
    EXPECT_NEAR(f.velocity_gradient[g].at[1][0], 0, 1e-13);
  }
}

}  // namespace
}  // namespace arenite::fields
