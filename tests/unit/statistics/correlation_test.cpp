#include "statistics/correlation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace arenite::statistics {
namespace {

TEST(Correlation, EqualValuesShareTheirRank) {
  EXPECT_EQ(ranks({3, 1, 3, 2, 3}), (std::vector<double>{4, 1, 4, 2, 4}));
}

TEST(Correlation, SpearmanSeesOrderAndPearsonALine) {
  std::vector<double> x, rising, line;
  for (int k = 0; k < 12; ++k) {
    x.push_back(k);
    rising.push_back(std::exp(k));
    line.push_back(2 - 3 * k);
  }
  EXPECT_NEAR(spearman(x, rising), 1, 1e-12);
  EXPECT_LT(pearson(x, rising), 0.7);
  EXPECT_NEAR(pearson(x, line), -1, 1e-12);
  const Relation relation = relate(x, line);
  EXPECT_NEAR(relation.line.slope, -3, 1e-12);
  EXPECT_NEAR(relation.line.intercept, 2, 1e-12);
  EXPECT_NEAR(relation.line.r2, 1, 1e-12);
  EXPECT_EQ(relation.count, 12u);
}

TEST(Correlation, KnownSmallCase) {
  // Ranks of y: 1 3 2 5 4; sum of squared differences 4, so rho = 1 - 6*4/(5*24).
  EXPECT_NEAR(spearman({1, 2, 3, 4, 5}, {0.1, 0.7, 0.2, 9, 1}), 1 - 24.0 / 120, 1e-12);
}

TEST(Correlation, ErrorsAreTheScatterOverRepeatedTrials) {
  double squares = 0, error = 0, slope_squares = 0, slope_error = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    RandomStream random(seed, Purpose::test);
    std::vector<double> x, y;
    for (int k = 0; k < 40; ++k) {
      x.push_back(random.normal());
      y.push_back(0.75 * x.back() + random.normal());  // correlation 0.6
    }
    const Relation r = relate(x, y);
    squares += (r.pearson.value - 0.6) * (r.pearson.value - 0.6) / 300;
    error += r.pearson.error / 300;
    slope_squares += (r.line.slope - 0.75) * (r.line.slope - 0.75) / 300;
    slope_error += r.line.slope_error / 300;
  }
  EXPECT_NEAR(error, std::sqrt(squares), 0.12 * error);
  EXPECT_NEAR(slope_error, std::sqrt(slope_squares), 0.12 * slope_error);
}

TEST(Correlation, UnknownRowsAreLeftOutAndNothingIsFeigned) {
  const double nan = unknown;
  const Relation r = relate({1, 2, nan, 4, 5}, {1, nan, 3, 4, 5.5});
  EXPECT_EQ(r.count, 3u);
  EXPECT_TRUE(std::isfinite(r.line.slope));
  EXPECT_FALSE(std::isfinite(relate({1, 1, 1}, {1, 2, 3}).spearman.value));
  EXPECT_FALSE(std::isfinite(relate({1}, {1}).pearson.value));
  EXPECT_THROW(relate({1, 2}, {1}), InputError);
}

TEST(Correlation, RootMeanSquareDifferenceByHand) {
  EXPECT_NEAR(rms_difference({1, 2, 3}, {1, 4, 7}), std::sqrt(20.0 / 3), 1e-15);
}

TEST(OverMean, LeavesUnknownValuesOutOfTheMeanAndUnknown) {
  const auto norm = over_mean({2, unknown, 6});
  EXPECT_EQ(norm[0], 0.5);
  EXPECT_TRUE(std::isnan(norm[1]));
  EXPECT_EQ(norm[2], 1.5);
  EXPECT_EQ(mean_of_known({2, unknown, 6}, {0, 1, 1}), 6);
  EXPECT_TRUE(std::isnan(mean_of_known({unknown})));
  EXPECT_TRUE(std::isnan(over_mean({1, -1})[0]));
}

}  // namespace
}  // namespace arenite::statistics
