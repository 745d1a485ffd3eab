#include "grains/texture/view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/random.hpp"
#include "grains/texture/distribution.hpp"
#include "statistics/tails.hpp"
#include "support/numbers_of.hpp"

namespace arenite::texture {
namespace {

using statistics::exponential_tail;
using statistics::TailFit;
using statistics::weak_exponent;
using test::error_of;
using test::list_of;
using test::value_of;

constexpr DistributionNames names{"mean", "", "share", "", ""};

std::vector<double> sorted(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v;
}

/// 1 + excess, excess exponential of rate beta.
std::vector<double> exponential(double beta, int n, std::uint64_t seed) {
  RandomStream random(seed, Purpose::test);
  std::vector<double> x;
  for (int k = 0; k < n; ++k) x.push_back(1 - std::log(1 - random.uniform()) / beta);
  return sorted(x);
}

TEST(ExponentialTail, GivesBackTheRate) {
  double mean = 0, squares = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const TailFit tail = exponential_tail(exponential(1.4, 400, seed));
    EXPECT_EQ(tail.count, 400u);
    EXPECT_TRUE(std::isnan(tail.slope.error));
    mean += tail.slope.value / 200;
    squares += (tail.slope.value - 1.4) * (tail.slope.value - 1.4) / 200;
  }
  EXPECT_NEAR(mean, 1.4, 4 * 0.07 / std::sqrt(200.0));
  EXPECT_NEAR(std::sqrt(squares), 0.07, 0.02);  // beta/sqrt(n) where values are independent
}

TEST(ExponentialTail, LineThroughAnExactExponentialHasItsSlope) {
  std::vector<double> x;
  for (int k = 0; k < 500; ++k) x.push_back(1 - std::log((k + 0.5) / 500) / 2.5);  // the quantiles themselves
  const TailFit tail = exponential_tail(sorted(x));
  EXPECT_NEAR(tail.line_slope.value, 2.5, 1e-10);
  EXPECT_NEAR(tail.line_r2, 1, 1e-12);
}

TEST(ExponentialTail, IsToldFromAHalfGaussianEitherWay) {
  const TailFit exponential_data = exponential_tail(exponential(1, 3000, 7));
  EXPECT_GT(exponential_data.likelihood_ratio.value, 0);
  RandomStream random(8, Purpose::test);
  std::vector<double> x;
  for (int k = 0; k < 500; ++k) x.push_back(1 + std::abs(random.normal()));
  const TailFit gaussian_data = exponential_tail(sorted(x));
  EXPECT_LT(gaussian_data.likelihood_ratio.value, 0);
  EXPECT_NEAR(statistics::chance_of_lead({-1.96, 1}), 0.975, 1e-4);
  EXPECT_TRUE(std::isnan(statistics::chance_of_lead({3})));
}

TEST(WeakPowerLaw, GivesBackItsExponent) {
  RandomStream random(11, Purpose::test);
  std::vector<double> x;
  for (int k = 0; k < 5000; ++k) x.push_back(std::pow(random.uniform(), 1 / (1 - 0.3)));  // pdf (1 - 0.3) x^-0.3
  EXPECT_NEAR(weak_exponent(sorted(x)), 0.3, 4 * 0.8 / std::sqrt(5000.0));
  const double without = weak_exponent(sorted(x));
  for (int k = 0; k < 100; ++k) x.push_back(1e-6);  // grains that something still touches, in a sample at rest
  EXPECT_DOUBLE_EQ(weak_exponent(sorted(x)), without);
}

TEST(Distribution, OfAPurelyExponentialForceHasKnownShares) {
  RandomStream random(2, Purpose::test);
  std::vector<double> force;
  for (int k = 0; k < 20000; ++k) force.push_back(-3 * std::log(1 - random.uniform()));
  Items items(force.size());
  std::iota(items.begin(), items.end(), 0);
  std::vector<int> block(force.size());
  for (std::size_t k = 0; k < block.size(); ++k) block[k] = static_cast<int>(k % 36);
  const Numbers d = distribution(items, items, block, force, 6.0, names);
  EXPECT_NEAR(value_of(d, "mean"), 3, 4 * error_of(d, "mean"));
  EXPECT_NEAR(error_of(d, "mean"), 3 / std::sqrt(20000.0), 0.35 * 3 / std::sqrt(20000.0));
  EXPECT_NEAR(value_of(d, "share"), std::exp(-1), 4 * error_of(d, "share"));
  EXPECT_NEAR(value_of(d, "fraction_above_mean_of_all"), std::exp(-2), 4 * error_of(d, "fraction_above_mean_of_all"));
  EXPECT_NEAR(value_of(d, "beta"), 1, 4 * error_of(d, "beta"));
  double area = 0;
  for (const double y : list_of(d, "pdf/y")) area += y * (value_of(d, "pdf/x/1") - value_of(d, "pdf/x/0"));
  EXPECT_NEAR(area, 1, 1e-12);
  EXPECT_NEAR(list_of(d, "cumulative/y").front(), 1, 1e-12);
  EXPECT_NEAR(list_of(d, "cumulative/x").back(), value_of(d, "maximum"), 1e-12);
}

TEST(Distribution, RelationOfExponentsHoldsForAPairThatObeysIt) {
  // T eq. 1.4 and 1.5 with alpha = 0: beta^2 = 2. Weak values uniform, strong ones exponential of rate sqrt(2), in the
  // numbers that make the density continuous and the mean one.
  const double beta = std::sqrt(2.0), k = 1 / (1 + 1 / beta);
  RandomStream random(4, Purpose::test);
  std::vector<double> force;
  for (int n = 0; n < 40000; ++n)
    force.push_back(random.uniform() < k ? random.uniform() : 1 - std::log(1 - random.uniform()) / beta);
  Items items(force.size());
  std::iota(items.begin(), items.end(), 0);
  std::vector<int> block(force.size());
  for (std::size_t n = 0; n < block.size(); ++n) block[n] = static_cast<int>(n % 36);
  const Numbers d = distribution(items, items, block, force, 1, names);
  EXPECT_NEAR(value_of(d, "mean"), 1, 0.02);
  EXPECT_NEAR(value_of(d, "beta2_over_product"), 1, 4 * error_of(d, "beta2_over_product"));
  EXPECT_NEAR(value_of(d, "k"), k, 4 * error_of(d, "k"));
}

/// Draws of the exponential, each `copies` times, as the contacts of one chain carry one force; copies lie in one
/// block.
struct Chains {
  std::vector<double> force;
  std::vector<int> block;
  Items items;

  Chains(std::size_t draws, std::size_t copies, std::uint64_t seed) {
    RandomStream random(seed, Purpose::test);
    for (std::size_t d = 0; d < draws; ++d) {
      const double f = -std::log(1 - random.uniform());
      for (std::size_t c = 0; c < copies; ++c) {
        items.push_back(force.size());
        force.push_back(f);
        block.push_back(static_cast<int>(d * 25 / draws));
      }
    }
  }
};

/// Of the values that a law takes over samples: their sums, and that of the squares of the errors told.
struct Scatter {
  double sum = 0, squares = 0, told = 0;

  double over_told(double n) const { return std::sqrt((squares - sum * sum / n) / (n - 1) / (told / n)); }
};

TEST(Distribution, ErrorsOfItsLawsAreThoseOfOtherSamplesThoughValuesDependOnEachOther) {
  constexpr std::array laws{"beta",  "beta_line", "alpha", "k", "beta2_over_product", "log_likelihood_ratio",
                            "share", "mean"};
  constexpr int seeds = 60;  // by which a scatter is known to 9 %
  for (const std::size_t copies : {1u, 4u}) {
    std::array<Scatter, laws.size()> scatter;
    for (int seed = 0; seed < seeds; ++seed) {
      const Chains chains(400, copies, static_cast<std::uint64_t>(seed));
      const Numbers d = distribution(chains.items, chains.items, chains.block, chains.force, 1, names);
      for (std::size_t law = 0; law < laws.size(); ++law) {
        const double value = value_of(d, laws[law]), error = error_of(d, laws[law]);
        scatter[law].sum += value;
        scatter[law].squares += value * value;
        scatter[law].told += error * error;
      }
    }
    for (std::size_t law = 0; law < laws.size(); ++law)
      EXPECT_NEAR(scatter[law].over_told(seeds), 1, 0.3) << laws[law] << ", " << copies << " of each";
  }
}

TEST(Jackknife, OfAMeanOfIndependentValuesIsItsStandardError) {
  const std::vector<double> value{3, 5, 4, 9, 1, 7};
  Items items(value.size());
  std::iota(items.begin(), items.end(), 0);
  const Estimate m = mean(items, {0, 1, 2, 3, 4, 5}, [&](std::size_t i) { return value[i]; });
  EXPECT_NEAR(m.error, standard_error(value), 1e-14);
}

TEST(Jackknife, OfCorrelatedValuesIsThatOfTheirBlocks) {
  // Ten blocks of ten equal values: only ten independent ones.
  std::vector<double> value, first;
  std::vector<int> block;
  for (int b = 0; b < 10; ++b) {
    first.push_back(b * b % 7);
    for (int k = 0; k < 10; ++k) {
      value.push_back(first.back());
      block.push_back(b);
    }
  }
  Items items(value.size());
  std::iota(items.begin(), items.end(), 0);
  EXPECT_NEAR(mean(items, block, [&](std::size_t i) { return value[i]; }).error, standard_error(first), 1e-14);
}

TEST(Jackknife, OfAnAngleDoesNotJumpWhereItWraps) {
  const std::vector<double> angle{179, 1, 178, 2};
  const auto estimate = jackknife({0, 1, 2, 3}, {0, 1, 2, 3},
                                  [&](const Items& items) {
                                    double x = 0, y = 0;
                                    for (const std::size_t i : items) {
                                      x += std::cos(angle[i] * std::acos(-1.0) / 90);
                                      y += std::sin(angle[i] * std::acos(-1.0) / 90);
                                    }
                                    const double mean = std::atan2(y, x) * 90 / std::acos(-1.0);
                                    return std::vector<double>{mean < 0 ? mean + 180 : mean};
                                  },
                                  {180});
  EXPECT_LT(estimate[0].error, 2);
}

TEST(Distribution, TheDensityOverTheMeanOfAllIsThatOfValuesOverThisMean) {
  // Mean 3, half the mean of all.
  const std::vector<double> force{1.5, 3, 4.5};
  const Numbers d = distribution({0, 1, 2}, {0, 1, 2}, {0, 1, 2}, force, 6.0, names);
  ASSERT_EQ(d["pdf_over_all"]["x"].size(), 8u);  // up to 0.75 in bins of 0.1
  double whole = 0;
  for (const double y : list_of(d, "pdf_over_all/y")) whole += 0.1 * y;
  EXPECT_NEAR(whole, 1, 1e-12);
  EXPECT_NEAR(value_of(d, "pdf_over_all/y/2"), 1 / 0.3, 1e-9);  // 0.25
  EXPECT_NEAR(value_of(d, "pdf_over_all/y/7"), 1 / 0.3, 1e-9);  // 0.75
}

}  // namespace
}  // namespace arenite::texture
