#include "statistics/tails.hpp"

#include <gtest/gtest.h>

#include "draws.hpp"

namespace arenite::statistics {
namespace {

const std::vector<double> held(36, 1.0);

double integral(double theta, double a, double b) {
  double sum = 0;
  const int n = 20000;
  for (int k = 0; k < n; ++k) {
    const double u = a + (b - a) * (k + 0.5) / n;
    sum += std::exp(-theta * u * u) * (b - a) / n;
  }
  return sum;
}

TEST(CutLaws, RateGivesBackTheMeanOfACutExponential) {
  for (const double s : {-3.0, -0.01, 1e-7, 0.5, 2.0, 40.0}) {
    const double length = 1.7, a = s * length;
    const double mean = std::abs(a) < 1e-4 ? length / 2 - length * a / 12 : 1 / s - length / std::expm1(a);
    EXPECT_NEAR(cut_exponential_rate(mean, length), s, 1e-6 * (1 + std::abs(s)));
    double sum = 0;
    for (int k = 0; k < 20000; ++k) sum += std::exp(-s * length * (k + 0.5) / 20000) * length / 20000;
    EXPECT_NEAR(log_integral_exponential(s, length), std::log(sum), 1e-5);
  }
}

TEST(CutLaws, GaussianIntegralAndRateAgreeWithSums) {
  for (const auto& [theta, a, b] :
       {std::array{2.0, 0.5, 1.5}, std::array{0.1, -1.0, 2.0}, std::array{30.0, 0.3, 0.9}, std::array{1e-12, 1.0, 3.0}})
    EXPECT_NEAR(log_integral_gaussian(theta, a, b), std::log(integral(theta, a, b)), 1e-6);
  const double h = 1e-5, theta = 5, a = 0.4, b = 1.2;  // mean square = -d ln Z / d theta
  const double mean_square =
      -(log_integral_gaussian(theta + h, a, b) - log_integral_gaussian(theta - h, a, b)) / (2 * h);
  EXPECT_NEAR(cut_gaussian_rate(mean_square, a, b), theta, 1e-4);
  EXPECT_NEAR(cut_gaussian_rate(0.99 * b * b, a, b), 0, 1e-6);  // values that pile up at the far end
}

TEST(TailFit, GivesBackAnExponentialWithinItsError) {
  int within = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const BlockedSample sample = drawn(20000, seed, [](RandomStream& r) { return -std::log(1 - r.uniform()); });
    const BlockCounts counts = counted(sample);
    const TailFit fit = fit_tail(sample, counts, held);
    EXPECT_NEAR(fit.slope.value, 1, 5 * fit.slope.error);
    EXPECT_NEAR(fit.line_slope.value, 1, 0.15);  // its bins of few values lean to the high side
    EXPECT_NEAR(fit.low, std::log(10), 5 * counts.bins.width);
    EXPECT_GT(fit.high, 5);
    within += std::abs(fit.slope.value - 1) < fit.slope.error;
    EXPECT_GT(fit.line_r2, 0.9);
  }
  EXPECT_NEAR(within / 40.0, 0.683, 0.2);
}

TEST(TailFit, TellsAnExponentialFromAGaussianAboutTheMeanEitherWay) {
  const BlockedSample exponential = drawn(100000, 5, [](RandomStream& r) { return -std::log(1 - r.uniform()); });
  const TailFit a = fit_tail(exponential, counted(exponential), held);
  EXPECT_GT(a.likelihood_ratio.value, 0);
  EXPECT_LT(a.p_value, 0.01);
  const BlockedSample gaussian = drawn(600000, 6, [](RandomStream& r) { return 1 + 0.2 * r.normal(); });
  const TailFit b = fit_tail(gaussian, counted(gaussian), held);
  EXPECT_LT(b.likelihood_ratio.value, 0);
  EXPECT_GT(b.p_value, 0.99);
}

TEST(TailFit, RangeOfAGaussianIsWhereItsDensityFallsToTheGivenShares) {
  const BlockedSample sample = drawn(1000000, 7, [](RandomStream& r) { return 1 + 0.2 * r.normal(); });
  const BlockCounts counts = counted(sample);
  const TailRange range = tail_range(counts.bins, counts.all);
  EXPECT_NEAR(range.low, 1 + 0.2 * std::sqrt(2 * std::log(10)), 2 * counts.bins.width);
  EXPECT_NEAR(range.high, 1 + 0.2 * std::sqrt(2 * std::log(1000)), 4 * counts.bins.width);
}

TEST(TailFit, NeighboursThatAreAlikeDoNotFeignPrecision) {
  // Every value sixteen times over: one in sixteen is independent, so errors are four times those of counting.
  double ratio = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    BlockedSample many = drawn(4000, seed, [](RandomStream& r) { return -std::log(1 - r.uniform()); });
    const BlockedSample once = many;
    for (int copy = 1; copy < 16; ++copy) {
      many.x.insert(many.x.end(), once.x.begin(), once.x.end());
      many.block.insert(many.block.end(), once.block.begin(), once.block.end());
    }
    const TailFit fit = fit_tail(many, counted(many), held);
    const double counting = fit.slope.value / std::sqrt(static_cast<double>(fit.count));
    ratio += fit.slope.error / counting / 20;
  }
  EXPECT_GT(ratio, 3.5);
  EXPECT_LT(ratio, 6);
}

TEST(TailFit, ScatterOfTheMeanGoesIntoTheErrorOfTheSlope) {
  const BlockedSample sample = drawn(200000, 10, [](RandomStream& r) { return -std::log(1 - r.uniform()); });
  const BlockCounts counts = counted(sample);
  std::vector<double> mean(36);
  for (std::size_t b = 0; b < 36; ++b) mean[b] = b % 2 ? 1.01 : 0.99;
  const TailFit alone = fit_tail(sample, counts, held), with = fit_tail(sample, counts, mean);
  const double part = 0.01 * std::sqrt(35.0) * with.slope.value;
  EXPECT_NEAR(with.slope.error, std::hypot(alone.slope.error, part), 0.15 * with.slope.error);
  EXPECT_GT(with.slope.error, 2 * alone.slope.error);
  EXPECT_EQ(with.slope.value, alone.slope.value);
}

TEST(TailFit, IsUnknownWithoutATail) {
  const BlockedSample uniform = drawn(100000, 8, [](RandomStream& r) { return r.uniform(0.5, 1.5); });
  EXPECT_FALSE(std::isfinite(fit_tail(uniform, counted(uniform), held).slope.value));
  const BlockedSample same = drawn(1000, 9, [](RandomStream&) { return 1.0; });
  EXPECT_FALSE(std::isfinite(fit_tail(same, counted(same), held).low));
}

TEST(CutExponential, HoldsItsShareBetweenItsEnds) {
  const CutExponential tail{.rate = 2.5, .low = 0.8, .high = 3, .share = 0.2};
  constexpr int steps = 2000;  // the midpoint rule is off by (rate step)^2/24, 3e-7
  const double step = (tail.high - tail.low) / steps;
  double sum = 0;
  for (int k = 0; k < steps; ++k) sum += step * tail.at(tail.low + (k + 0.5) * step);
  EXPECT_NEAR(sum, 0.2, 1e-6 * 0.2);
  EXPECT_NEAR(tail.at(2) / tail.at(1), std::exp(-2.5), 1e-12);
  EXPECT_FALSE(CutExponential{.rate = 1}.is_known());
}

TEST(FallBeyondMean, MeetsTheWeakLawAtTheMean) {
  const FallBeyondMean strong{0.4, 1.2};
  EXPECT_DOUBLE_EQ(strong.at(1), (WeakPowerLaw{0.4, 0.3}.at(1)));
  EXPECT_NEAR(strong.at(strong.where(0.01)), 0.01, 1e-14);
  EXPECT_FALSE(FallBeyondMean{.level = 0.4}.is_known());
}

}  // namespace
}  // namespace arenite::statistics
