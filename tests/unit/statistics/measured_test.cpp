#include "statistics/measured.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace {
using namespace arenite;
using namespace arenite::statistics;

TEST(Measured, MeanWithItsErrorAndInterval) {
  const Measured m = mean_of({1, 2, 3, 6});
  EXPECT_DOUBLE_EQ(m.value, 3);
  EXPECT_NEAR(m.error, std::sqrt(14.0 / 3 / 4), 1e-15);
  EXPECT_EQ(m.freedom, 3);
  const auto range = confidence_95(m);
  EXPECT_NEAR(range.high - 3, 3.182446305284263 * m.error, 1e-12);
  EXPECT_NEAR(range.low + range.high, 6, 1e-14);
  EXPECT_TRUE(std::isnan(mean_of({5}).error));
  EXPECT_TRUE(std::isnan(confidence_95(mean_of({5})).low));
}

TEST(Measured, MeanOfDirectionsIsAcrossTheEndOfTheirPeriod) {
  const Measured m = mean_of_angles({178, 2, 176, 4}, 180), plain = mean_of({-2, 2, -4, 4});
  EXPECT_NEAR(std::remainder(m.value, 180), 0, 1e-9);
  EXPECT_NEAR(m.error, plain.error, 1e-9);
  EXPECT_NEAR(mean_of_angles({59, 1, 3}, 60).value, 1, 1e-9);
  EXPECT_TRUE(std::isnan(mean_of_angles({}, 180).value));
}

TEST(Measured, ProductsAddRelativeErrorsInSquares) {
  const Measured p = product({{{4, 0.4, 5}, 0.5}, {{2, 0.1, 8}, -1}, {{3}, 2}});
  EXPECT_DOUBLE_EQ(p.value, 9);
  EXPECT_NEAR(p.error / p.value, std::hypot(0.05, 0.05), 1e-15);
  EXPECT_NEAR(p.freedom, 4 / (1.0 / 5 + 1.0 / 8), 1e-12);  // Welch and Satterthwaite with equal parts
  EXPECT_TRUE(std::isnan(product({{{4}, 1}, {{2}, 1}}).error));
}

TEST(Measured, IntervalOfAProductCoversTheTruth) {
  int covered = 0;
  constexpr int seeds = 2000;
  for (int seed = 0; seed < seeds; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed), Purpose::test);
    std::vector<double> a, b;
    for (int k = 0; k < 5; ++k) a.push_back(10 + random.normal());
    for (int k = 0; k < 4; ++k) b.push_back(7 + random.normal());
    const auto range = confidence_95(product({{mean_of(a), 1}, {mean_of(b), -1}}));
    covered += range.low <= 10.0 / 7 && 10.0 / 7 <= range.high;
  }
  EXPECT_NEAR(covered / double(seeds), 0.95, 0.02);
}

TEST(Measured, ChanceOfEqualMeans) {
  // Two groups: analysis of variance is the t test.
  const std::vector<double> a{1, 2, 3}, b{2, 4, 6};
  const double t = 2 / std::sqrt((2.0 + 8.0) / 4 * (2.0 / 3));
  EXPECT_NEAR(chance_of_equal_means({a, b}), 1 - t * (6 + t * t) / std::pow(4 + t * t, 1.5), 1e-12);
  EXPECT_TRUE(std::isnan(chance_of_equal_means({a})));
  EXPECT_TRUE(std::isnan(chance_of_equal_means({{1}, {2}})));
}

}  // namespace
