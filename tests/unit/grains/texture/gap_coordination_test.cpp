#include "grains/texture/texture.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "grains/texture/gap_coordination.hpp"
#include "support/numbers_of.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::texture {
namespace {

using test::error_of;
using test::value_of;

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
  const Numbers z = gap_coordination(striped(0.05), 0.0501);
  EXPECT_EQ(value_of(z, "large_grains"), 24);
  EXPECT_EQ(value_of(z, "small_grains"), 12);
  EXPECT_DOUBLE_EQ(value_of(z, "Z_ll"), 3);
  EXPECT_DOUBLE_EQ(value_of(z, "Z_ls"), 1);
  EXPECT_DOUBLE_EQ(value_of(z, "Z_sl"), 2);
  EXPECT_DOUBLE_EQ(value_of(z, "Z_ss"), 2);
  EXPECT_DOUBLE_EQ(value_of(z, "Z_l"), 4);
  EXPECT_DOUBLE_EQ(value_of(z, "Z_s"), 4);
  EXPECT_DOUBLE_EQ(value_of(z, "Z"), 4);
  EXPECT_NEAR(error_of(z, "Z_ls"), 0, 1e-12);  // every large grain has the same neighbours
}

TEST(GapCoordination, ReachesAsFarAsTheGapAndNoFarther) {
  EXPECT_DOUBLE_EQ(value_of(gap_coordination(striped(0.05), 0.0499), "Z"), 0);
  const double diagonal = std::sqrt(2.0) - 0.95;  // gap to the next but one, where diagonals count too
  const Numbers z = gap_coordination(striped(0.05), diagonal + 1e-9);
  EXPECT_DOUBLE_EQ(value_of(z, "Z_ll"), 5);  // 3 as before and the two diagonals on the side of the large column
  EXPECT_DOUBLE_EQ(value_of(z, "Z_sl"), 6);
  EXPECT_DOUBLE_EQ(value_of(z, "Z_l"), 8);
}

TEST(GapCoordination, CountsGrainsInTheWindowWithNeighboursBeyond) {
  const Packing p = striped(0);
  const Numbers z = gap_coordination(p, 0.01, 0, 1, geometry::Rectangle{2, 3, 0, 6});  // one small column
  EXPECT_EQ(value_of(z, "large_grains"), 0);
  EXPECT_EQ(value_of(z, "small_grains"), 6);
  EXPECT_DOUBLE_EQ(value_of(z, "Z_sl"), 2);
  EXPECT_DOUBLE_EQ(value_of(z, "Z_ss"), 2);
  EXPECT_TRUE(std::isnan(value_of(z, "Z_l")));
  EXPECT_TRUE(std::isnan(value_of(z, "Z")));
}

TEST(GapCoordination, ErrorsComeFromTheScatterOfIndependentPieces) {
  Packing p = test::empty_box(100, 100);  // pairs LL and single L, far apart from each other
  for (int k = 0; k < 8; ++k) {
    test::add_grain(p, {10.0 + 10 * k, 50}, 0.5, 0);
    if (k < 2) test::add_grain(p, {10.0 + 10 * k, 51}, 0.5, 1);
  }
  const Numbers z = gap_coordination(p, 0.1);
  EXPECT_DOUBLE_EQ(value_of(z, "Z_ls"), 0.25);
  EXPECT_DOUBLE_EQ(value_of(z, "Z_sl"), 1);
  EXPECT_DOUBLE_EQ(value_of(z, "Z"), 0.625);
  EXPECT_GT(error_of(z, "Z_ls"), 0.1);
  EXPECT_LT(error_of(z, "Z_ls"), 0.25);
  EXPECT_NEAR(error_of(z, "Z_sl"), 0, 1e-12);
}

TEST(GapCoordination, RefusesANegativeGapAndOneClassOnly) {
  EXPECT_THROW(gap_coordination(striped(0), -1e-9), InputError);
  EXPECT_THROW(gap_coordination(striped(0), NAN), InputError);
  EXPECT_THROW(gap_coordination(striped(0), 0.1, 1, 1), InputError);
  EXPECT_TRUE(std::isnan(value_of(gap_coordination(test::empty_box(1, 1), 0.1), "Z")));
}

/// Neighbours by comparing every grain with every image of every other.
int neighbours_by_brute_force(const Packing& p, std::size_t g, int of_material, double gap) {
  const int nx = p.domain.periodic[0] ? 4 : 0, ny = p.domain.periodic[1] ? 3 : 0;
  int count = 0;
  for (std::size_t h = 0; h < p.grains.size(); ++h)
    for (int ix = -nx; ix <= nx; ++ix)
      for (int iy = -ny; iy <= ny; ++iy) {
        if ((h == g && ix == 0 && iy == 0) || p.grains.material[h] != of_material) continue;
        const Vec2 image =
            p.grains.position[h] + Vec2{ix * p.domain.width() + iy * p.domain.tilt, iy * p.domain.height()};
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
    test::add_grain(p, {random.uniform(0, p.domain.width()), random.uniform(0, p.domain.height())},
                    random.uniform(0.02, 0.5), static_cast<int>(random.below(3)));
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
  const Numbers z = gap_coordination(p, 0.1, 0, 1, cut ? std::optional(window) : std::nullopt);
  RC_ASSERT(value_of(z, "large_grains") == count[0]);
  RC_ASSERT(value_of(z, "small_grains") == count[1]);
  const auto is = [&](const char* name, double top, double under) {
    return under > 0 ? std::abs(value_of(z, name) - top / under) < 1e-12 : std::isnan(value_of(z, name));
  };
  RC_ASSERT(is("Z_ll", sum[0][0], count[0]));
  RC_ASSERT(is("Z_ls", sum[0][1], count[0]));
  RC_ASSERT(is("Z_sl", sum[1][0], count[1]));
  RC_ASSERT(is("Z_ss", sum[1][1], count[1]));
  RC_ASSERT(is("Z_s", sum[1][0] + sum[1][1], count[1]));
}

}  // namespace
}  // namespace arenite::texture
