#include "grains/packing/population.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace arenite::packing {
namespace {

const Materials two{{"POM", 1410, 27.35e6, 0}, {"HDPE", 950, 6.43e6, 0}};

Population of(const std::string& material, double diameter) {
  Population p;
  p.material = material;
  p.size = FixedSize{diameter};
  return p;
}

TEST(Population, CountsAreKeptAndMaterialsAreMixed) {
  auto a = of("POM", 0.0164), b = of("HDPE", 0.0105);
  a.count = 334;
  b.count = 371;
  const auto g = draw_grains({a, b}, two, 0, 8);
  ASSERT_EQ(g.size(), 705u);
  EXPECT_EQ(std::count(g.material.begin(), g.material.end(), 0), 334);
  for (std::size_t i = 0; i < g.size(); ++i) EXPECT_EQ(g.radius[i], g.material[i] == 0 ? 0.0082 : 0.00525);
  const auto first = std::count(g.material.begin(), g.material.begin() + 352, 0);
  EXPECT_NEAR(static_cast<double>(first), 334.0 / 2, 4 * std::sqrt(705 * 0.25 / 2));
}

TEST(Population, RatiosShareTheTotalExactly) {
  auto a = of("POM", 0.01), b = of("HDPE", 0.01);
  a.ratio = 1;
  b.ratio = 8;
  const auto g = draw_grains({a, b}, two, 4000, 1);
  EXPECT_EQ(g.size(), 4000u);
  EXPECT_EQ(std::count(g.material.begin(), g.material.end(), 0), 444);
}

TEST(Population, UniformAndCutNormalLawsHaveTheirMoments) {
  auto a = of("POM", 0);
  a.count = 20000;
  a.size = UniformSizes{0.008, 0.016};
  auto moments = [](const Grains& g) {
    double m = 0, v = 0;
    for (const double r : g.radius) m += 2 * r;
    m /= static_cast<double>(g.size());
    for (const double r : g.radius) v += (2 * r - m) * (2 * r - m);
    return std::pair{m, std::sqrt(v / static_cast<double>(g.size()))};
  };
  const auto [mu, su] = moments(draw_grains({a}, two, 0, 3));
  EXPECT_NEAR(mu, 0.012, 4 * 0.00231 / std::sqrt(20000));
  EXPECT_NEAR(su, 0.008 / std::sqrt(12), 1e-4);
  a.size = NormalSizes{{0.008, 0.016}, 0.012, 0.001};
  const auto g = draw_grains({a}, two, 0, 3);
  const auto [mn, sn] = moments(g);
  EXPECT_NEAR(mn, 0.012, 4 * 0.001 / std::sqrt(20000));
  EXPECT_NEAR(sn, 0.001, 3e-5);
}

TEST(Population, SameSeedSameGrainsOtherSeedOthers) {
  auto a = of("POM", 0);
  a.count = 100;
  a.size = UniformSizes{1, 2};
  EXPECT_EQ(draw_grains({a}, two, 0, 5).radius, draw_grains({a}, two, 0, 5).radius);
  EXPECT_NE(draw_grains({a}, two, 0, 5).radius, draw_grains({a}, two, 0, 6).radius);
}

TEST(Population, UnknownMaterialAndNoGrainsAreRefused) {
  auto a = of("STEEL", 0.01);
  a.count = 1;
  EXPECT_THROW(draw_grains({a}, two, 0, 1), InputError);
  EXPECT_THROW(draw_grains({}, two, 0, 1), InputError);
  auto b = of("POM", 0.01), c = of("POM", 0.01);
  b.count = 10;
  c.ratio = 1;
  EXPECT_THROW(draw_grains({b, c}, two, 10, 1), InputError);
}

}  // namespace
}  // namespace arenite::packing
