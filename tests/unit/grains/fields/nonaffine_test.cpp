#include "grains/fields/nonaffine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "grains/texture/view.hpp"
#include "model/periodic_images.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::fields {
namespace {

Packing scattered(std::uint64_t seed, bool periodic_x, bool periodic_y, double tilt = 0) {
  RandomStream random(seed, Purpose::test);
  Packing p = test::empty_box(10, 8);
  p.domain.periodic[0] = periodic_x;
  p.domain.periodic[1] = periodic_y;
  p.domain.tilt = tilt;
  for (int g = 0; g < 120; ++g) test::add_grain(p, {random.uniform(0, 10), random.uniform(0, 8)}, 0.3);
  return p;
}

Vec2 times(const Tensor2& a, Vec2 b) { return {a.xx * b.x + a.xy * b.y, a.yx * b.x + a.yy * b.y}; }

/// Every grain moved by x' = F x + c, the cell with them, and grains put back into it.
Packing moved(Packing p, const Tensor2& f, Vec2 shift) {
  for (std::size_t g = 0; g < p.grains.size(); ++g) {
    const Vec2 to = times(f, p.grains.position[g]) + shift;
    p.grains.position[g] = to;
  }
  if (p.domain.periodic[1]) p.domain.tilt = f.xx * p.domain.tilt + f.xy * p.domain.height();
  p.domain.wall[right].position *= f.xx;
  p.domain.wall[top].position *= f.yy;
  for (std::size_t g = 0; g < p.grains.size(); ++g) {
    const Vec2 in = p.domain.wrapped(p.grains.position[g]);
    p.grains.position[g] = in;
  }
  return p;
}

TEST(NonAffine, AnAffineMotionLeavesNothing) {
  // Coordinates of 10 m are rounded by 2e-15 m and sums of twenty of them, through a matrix inverse, by some 1e-14; a
  // squared length by 1e-28 and less.
  struct Case {
    std::array<bool, 2> periodic;
    double tilt;
    Tensor2 f;
  };
  for (const Case& c :
       {Case{{false, false}, 0, {1.1, 0.3, -0.4, 0.9}},                                        // with a rotation
        Case{{true, true}, 0, {1.02, 0.1, 0, 0.97}}, Case{{true, true}, 3.3, {1, 4.7, 0, 1}},  // sheared by 470 %
        Case{{true, true}, -40, {0.5, -0.6, 0, 1.3}}, Case{{true, false}, 0, {1.2, 0, 0, 0.7}},
        Case{{false, true}, 0, {1.2, 0, 0, 0.7}}}) {
    const Packing before = scattered(4, c.periodic[0], c.periodic[1], c.tilt),
                  after = moved(before, c.f, {1.7, c.periodic[1] ? -0.9 : 0.0});
    const LocalDeformation local = local_deformation(before, after, 3);
    for (std::size_t g = 0; g < before.grains.size(); ++g) {
      ASSERT_GE(local.neighbours[g], 3);
      EXPECT_LT(local.d2min[g], 1e-27);
      EXPECT_NEAR(local.strain[g].xx, c.f.xx - 1, 1e-12);
      EXPECT_NEAR(local.strain[g].xy, (c.f.xy + c.f.yx) / 2, 1e-12);
      EXPECT_NEAR(local.strain[g].yy, c.f.yy - 1, 1e-12);
      EXPECT_NEAR(local.rotation[g], (c.f.yx - c.f.xy) / 2, 1e-12);
    }
    const AffineFit fit = affine_fit(before, after);
    EXPECT_LT(fit.fluctuation, 1e-13);
    EXPECT_NEAR(fit.gradient.xy, c.f.xy, 1e-13);
    EXPECT_NEAR(fit.gradient.yy, c.f.yy, 1e-13);
  }
}

TEST(NonAffine, NeighboursAreThoseThatComparingAllImagesGives) {
  const double range = 2.3;
  for (const double tilt : {0.0, 4.0, -17.5}) {
    const Packing p = scattered(6, true, true, tilt);
    const LocalDeformation local = local_deformation(p, p, range);
    for (std::size_t g = 0; g < p.grains.size(); ++g) {
      int count = 0;
      for (std::size_t h = 0; h < p.grains.size(); ++h)
        for (int row = -1; row <= 1; ++row)
          for (int column = -4; column <= 4; ++column)
            count += h != g && norm(p.grains.position[h] + Vec2{10 * column + tilt * row, 8.0 * row} -
                                    p.grains.position[g]) <= range;
      EXPECT_EQ(local.neighbours[g], count) << tilt;
    }
  }
}

TEST(NonAffine, KnowsTheGrainThatLeftTheRest) {
  // A square lattice in which one grain moved by d = (0.1, 0) against its four neighbours at distance 1. At that grain
  // every r' is r - d, and since the r cancel each other F = 1, so D2min = d^2. For a neighbour on the x-axis, X = sum
  // r' (x) r gains d (x) (-e_x), F_xx - 1 = -0.1/2: |r' - F r| is 0.05 at two of four neighbours.
  const Packing before = test::square_lattice(8);
  Packing after = before;
  after.grains.position[27].x += 0.1;
  const LocalDeformation local = local_deformation(before, after, 1.1);
  EXPECT_NEAR(local.d2min[27], 0.01, 1e-15);
  EXPECT_NEAR(local.strain[27].xx, 0, 1e-14);
  EXPECT_NEAR(local.d2min[28], 2 * 0.0025 / 4, 1e-15);
  EXPECT_NEAR(local.strain[28].xx, -0.05, 1e-14);
  EXPECT_NEAR(local.d2min[0], 0, 1e-27);
  // The fit to all: 1 of 64 moved, by 0.1 against the mean motion and a gradient that takes no more than a share 3/64
  // of the sum of squares.
  const AffineFit fit = affine_fit(before, after);
  EXPECT_LT(fit.fluctuation, std::sqrt(0.01 / 64));
  EXPECT_GT(fit.fluctuation, std::sqrt(0.01 / 64 * (1 - 4.0 / 64)));
  EXPECT_EQ(
      std::max_element(fit.residual.begin(), fit.residual.end(), [](Vec2 a, Vec2 b) { return norm(a) < norm(b); }) -
          fit.residual.begin(),
      27);
}

TEST(NonAffine, MeasuresTheNoiseOnTopOfAShear) {
  // Displacements of deviation s along each axis on top of a shear: r' carries the noise of both grains, 4 s^2 in all.
  // The grain's own part, 2 s^2, is common to its neighbours and is left nearly whole; of their 2 s^2 the fit takes up
  // a share 2/N.
  const double s = 0.01;
  RandomStream random(3, Purpose::test);
  const Packing before = scattered(8, true, true, 1.5);
  Packing after = moved(before, {1, 0.2, 0, 1}, {});
  for (std::size_t g = 0; g < after.grains.size(); ++g) {
    after.grains.position[g].x += s * random.normal();
    after.grains.position[g].y += s * random.normal();
  }
  const LocalDeformation local = local_deformation(before, after, 2);
  double mean = 0;
  for (const double d : local.d2min) mean += d / static_cast<double>(local.d2min.size());
  EXPECT_GT(mean, 2 * s * s);
  EXPECT_LT(mean, 4 * s * s);
  const AffineFit fit = affine_fit(before, after);
  EXPECT_NEAR(fit.fluctuation, std::sqrt(2) * s, 0.2 * s);  // 240 numbers: 4.6 % of it, three times
  EXPECT_NEAR(fit.gradient.xy, 0.2, 5 * s / (8 / std::sqrt(12.0)) / std::sqrt(120.0));
}

TEST(NonAffine, LeavesOpenWhatTooFewNeighboursDoNotTell) {
  Packing p = test::empty_box(10, 10);
  for (int k = 0; k < 4; ++k) test::add_grain(p, {1.0 + k, 5}, 0.5);  // in one line
  test::add_grain(p, {9, 9}, 0.5);
  const LocalDeformation local = local_deformation(p, p, 3.5);
  EXPECT_EQ(local.neighbours, (std::vector<std::int32_t>{3, 3, 3, 3, 0}));
  for (const double d : local.d2min) EXPECT_TRUE(std::isnan(d));
  EXPECT_TRUE(std::isnan(affine_fit(test::empty_box(1, 1), test::empty_box(1, 1)).fluctuation));
  EXPECT_THROW(local_deformation(p, p, 0), InputError);
  EXPECT_THROW(local_deformation(p, test::empty_box(10, 10), 1), InputError);
  Packing other = p;
  other.domain.periodic[0] = true;
  EXPECT_THROW(affine_fit(p, other), InputError);
}

}  // namespace
}  // namespace arenite::fields
