#include "thermal/identify/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "statistics/correlation.hpp"

namespace {
using namespace arenite;
using identify::regress;

/// Share of seeds whose interval covers the slope 3 of a line whose noise remembers the share `memory` of itself.
double coverage(std::size_t points, double memory, bool through_origin, int seeds) {
  int covered = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed), Purpose::test);
    std::vector<double> x, y;
    double noise = random.normal() / std::sqrt(1 - memory * memory);
    for (std::size_t k = 0; k < points; ++k) {
      x.push_back(1 + static_cast<double>(k) / static_cast<double>(points));
      y.push_back((through_origin ? 0.0 : 5.0) + 3 * x.back() + noise);
      noise = memory * noise + random.normal();
    }
    const auto range = statistics::confidence_95(regress(x, y, through_origin).slope);
    covered += range.low <= 3 && 3 <= range.high;
  }
  return covered / double(seeds);
}

TEST(Regression, FourPointsAreLeastSquaresWithStudentsT) {
  const std::vector<double> x{1, 2, 3, 4}, y{1.1, 1.9, 3.2, 3.9};
  const auto r = regress(x, y);
  const auto line = statistics::fit_line(x, y);
  EXPECT_NEAR(r.slope.value, 0.97, 1e-14);
  EXPECT_NEAR(r.slope.error, line.slope_error, 1e-14);
  EXPECT_NEAR(r.intercept.value, 0.1, 1e-13);
  EXPECT_NEAR(r.intercept.error, line.intercept_error, 1e-14);
  EXPECT_NEAR(r.r2, line.r2, 1e-14);
  EXPECT_EQ(r.slope.freedom, 2);
}

TEST(Regression, ThroughTheOrigin) {
  const auto r = regress({1, 2, 3}, {2.1, 3.9, 6.3}, true);
  EXPECT_NEAR(r.slope.value, 28.8 / 14, 1e-14);
  EXPECT_EQ(r.intercept.value, 0);
  EXPECT_EQ(r.slope.freedom, 2);
}

TEST(Regression, ALineIsExactAndTooFewPointsAreUnknown) {
  const auto r = regress({1, 2, 3, 7}, {3, 5, 7, 15});
  EXPECT_NEAR(r.slope.value, 2, 1e-14);
  EXPECT_LT(r.slope.error, 1e-13);
  EXPECT_TRUE(std::isnan(regress({1, 2}, {1, 2}).slope.value));
  EXPECT_TRUE(std::isnan(regress({2, 2, 2}, {1, 2, 3}).slope.value));
}

TEST(Regression, IntervalsCoverTheTruthAsOftenAsTheySay) {
  EXPECT_NEAR(coverage(4, 0, false, 3000), 0.95, 0.015);
  EXPECT_NEAR(coverage(4, 0, true, 3000), 0.95, 0.015);
  EXPECT_NEAR(coverage(60, 0, false, 3000), 0.95, 0.015);
}

TEST(Regression, IntervalsHoldForNoiseThatRemembers) {
  // Taken for independent, such points would give intervals that cover the slope in half of the cases.
  EXPECT_NEAR(coverage(400, 0.6, false, 1500), 0.95, 0.025);
  EXPECT_NEAR(coverage(400, 0.9, false, 1500), 0.95, 0.05);
}

}  // namespace
