#include "grains/texture/texture.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::texture {
namespace {

/// 6 x 6 periodic square lattice with columns L L S L L S; grains are `shrink` narrower than touching ones.
Packing striped(double shrink) {
  Packing p = test::square_lattice(6);
  for (std::size_t g = 0; g < p.grains.size(); ++g) {
    p.grains.material[g] = g % 6 % 3 == 2 ? 1 : 0;
    p.grains.radius[g] -= shrink / 2;
  }
  return p;
}

TEST(GapCoordination, OfAStripedLatticeIsCountedByHand) {
  // Along a row L touches L once and S once, S touches L twice; along a column like touches like twice.
  const GapCoordination z = gap_coordination(striped(0.05), 0.0501);
  EXPECT_EQ(z.large, 24u);
  EXPECT_EQ(z.small, 12u);
  EXPECT_DOUBLE_EQ(z.ll.value, 3);
  EXPECT_DOUBLE_EQ(z.ls.value, 1);
  EXPECT_DOUBLE_EQ(z.sl.value, 2);
  EXPECT_DOUBLE_EQ(z.ss.value, 2);
  EXPECT_DOUBLE_EQ(z.l.value, 4);
  EXPECT_DOUBLE_EQ(z.s.value, 4);
  EXPECT_DOUBLE_EQ(z.mean.value, 4);
  EXPECT_NEAR(z.ls.error, 0, 1e-12);  // every large grain has the same neighbours
}

TEST(GapCoordination, ReachesAsFarAsTheGapAndNoFarther) {
  EXPECT_DOUBLE_EQ(gap_coordination(striped(0.05), 0.0499).mean.value, 0);
  const double diagonal = std::sqrt(2.0) - 0.95;  // gap to the next but one, where diagonals count too
  const GapCoordination z = gap_coordination(striped(0.05), diagonal + 1e-9);
  EXPECT_DOUBLE_EQ(z.ll.value, 5);  // 3 as before and the two diagonals on the side of the large column
  EXPECT_DOUBLE_EQ(z.sl.value, 6);
  EXPECT_DOUBLE_EQ(z.l.value, 8);
}

TEST(GapCoordination, CountsGrainsInTheWindowWithNeighboursBeyond) {
  const Packing p = striped(0);
  const GapCoordination z = gap_coordination(p, 0.01, 0, 1, geometry::Rectangle{2, 3, 0, 6});  // one small column
  EXPECT_EQ(z.large, 0u);
  EXPECT_EQ(z.small, 6u);
  EXPECT_DOUBLE_EQ(z.sl.value, 2);
  EXPECT_DOUBLE_EQ(z.ss.value, 2);
  EXPECT_TRUE(std::isnan(z.l.value));
  EXPECT_TRUE(std::isnan(z.mean.value));
}

TEST(GapCoordination, ErrorsComeFromTheScatterOfIndependentPieces) {
  Packing p = test::empty_box(100, 100);  // pairs LL and single L, far apart from each other
  for (int k = 0; k < 8; ++k) {
    test::add_grain(p, {10.0 + 10 * k, 50}, 0.5, 0);
    if (k < 2) test::add_grain(p, {10.0 + 10 * k, 51}, 0.5, 1);
  }
  const GapCoordination z = gap_coordination(p, 0.1);
  EXPECT_DOUBLE_EQ(z.ls.value, 0.25);
  EXPECT_DOUBLE_EQ(z.sl.value, 1);
  EXPECT_DOUBLE_EQ(z.mean.value, 0.625);
  EXPECT_GT(z.ls.error, 0.1);
  EXPECT_LT(z.ls.error, 0.25);
  EXPECT_NEAR(z.sl.error, 0, 1e-12);
}

TEST(GapCoordination, RefusesANegativeGapAndOneClassOnly) {
  EXPECT_THROW(gap_coordination(striped(0), -1e-9), InputError);
  EXPECT_THROW(gap_coordination(striped(0), NAN), InputError);
  EXPECT_THROW(gap_coordination(striped(0), 0.1, 1, 1), InputError);
  EXPECT_TRUE(std::isnan(gap_coordination(test::empty_box(1, 1), 0.1).mean.value));
}

/// Neighbours by comparing every grain with every image of every other.
int neighbours_by_brute_force(const Packing& p, std::size_t g, int of_material, double gap) {
  const int nx = p.domain.periodic[0] ? 4 : 0, ny = p.domain.periodic[1] ? 3 : 0;
  int count = 0;
  for (std::size_t h = 0; h < p.grains.size(); ++h)
    for (int ix = -nx; ix <= nx; ++ix)
      for (int iy = -ny; iy <= ny; ++iy) {
        if ((h == g && ix == 0 && iy == 0) || p.grains.material[h] != of_material) continue;
        const Vec2 image = p.grains.position[h] + Vec2{ix * p.domain.width() + iy * p.domain.tilt, iy * p.domain.height()};
        count += norm(image - p.grains.position[g]) <= p.grains.radius[g] + p.grains.radius[h] + gap;
      }
  return count;
}

RC_GTEST_PROP(GapCoordination, IsWhatComparingAllWithAllGives, ()) {
  RandomStream random(*rc::gen::arbitrary<std::uint64_t>(), Purpose::test);
  Packing p = test::empty_box(*rc::gen::element(2.5, 6.0), *rc::gen::element(2.5, 5.0));
  p.domain.periodic[0] = *rc::gen::arbitrary<bool>();
  p.domain.periodic[1] = *rc::gen::arbitrary<bool>();
  if (p.domain.periodic[0] && p.domain.periodic[1]) p.domain.tilt = *rc::gen::element(0.0, 0.7, -1.9);
  const int n = *rc::gen::inRange(1, 40);
  for (int g = 0; g < n; ++g)
    test::add_grain(p, {random.uniform(0, p.domain.width()), random.uniform(0, p.domain.height())}, random.uniform(0.02, 0.5),
                    static_cast<int>(random.below(3)));
  const geometry::Rectangle window{0.4, 2.0, 0.3, 2.2};
  const bool cut = *rc::gen::arbitrary<bool>();
  double count[2] = {0, 0}, sum[2][2] = {{0, 0}, {0, 0}};
  for (std::size_t g = 0; g < p.grains.size(); ++g) {
    const int m = p.grains.material[g];
    const Vec2 c = p.grains.position[g];
    if (m > 1 || (cut && (c.x < 0.4 || c.x > 2.0 || c.y < 0.3 || c.y > 2.2))) continue;
    ++count[m];
    for (int k = 0; k < 2; ++k) sum[m][k] += neighbours_by_brute_force(p, g, k, 0.1);
  }
  const GapCoordination z = gap_coordination(p, 0.1, 0, 1, cut ? std::optional(window) : std::nullopt);
  RC_ASSERT(static_cast<double>(z.large) == count[0]);
  RC_ASSERT(static_cast<double>(z.small) == count[1]);
  const auto is = [](const statistics::Estimate& e, double top, double under) {
    return under > 0 ? std::abs(e.value - top / under) < 1e-12 : std::isnan(e.value);
  };
  RC_ASSERT(is(z.ll, sum[0][0], count[0]));
  RC_ASSERT(is(z.ls, sum[0][1], count[0]));
  RC_ASSERT(is(z.sl, sum[1][0], count[1]));
  RC_ASSERT(is(z.ss, sum[1][1], count[1]));
  RC_ASSERT(is(z.s, sum[1][0] + sum[1][1], count[1]));
}

}  // namespace
}  // namespace arenite::texture
