#include "validation/trends.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace arenite::validation {
namespace {

Series points(const std::vector<double>& y, double error, std::size_t runs = 5) {
  Series all;
  for (std::size_t i = 0; i < y.size(); ++i) all.push_back({static_cast<double>(i), y[i], error, runs});
  return all;
}

TEST(Trends, SlopeOfALineIsItsSlopeWithTheErrorOfItsMeans) {
  const Value s = slope(points({1, 3, 5}, 0.1));
  EXPECT_DOUBLE_EQ(s.value, 2);
  EXPECT_NEAR(s.error, 0.1 / std::sqrt(2.0), 1e-12);  // sigma / sqrt(Sxx), Sxx = 2
  EXPECT_NEAR(s.freedom, 8, 1e-9);                    // the two ends have four each
  EXPECT_NEAR(line_r2(points({1, 3, 5}, 0.1)), 1, 1e-12);
}

TEST(Trends, SlopeWithoutErrorsTakesTheScatterAboutTheLine) {
  const Value s = slope(points({0, 1.1, 1.9, 3}, statistics::unknown, 1));
  EXPECT_NEAR(s.value, 0.98, 1e-12);
  EXPECT_GT(s.error, 0);
  EXPECT_EQ(s.freedom, 2);
}

TEST(Trends, RankCorrelationSeesOrderOnly) {
  EXPECT_NEAR(spearman(points({1, 10, 11, 1000}, 1)), 1, 1e-12);
  EXPECT_NEAR(spearman(points({9, 3, 2, 1}, 1)), -1, 1e-12);
}

TEST(Monotone, ARiseMayHaveStepsDownWithinTheError) {
  const std::vector<double> noisy{4.3, 4.42, 4.40, 4.55, 4.54, 4.7};
  EXPECT_EQ(monotone("z", "rises", points(noisy, 0.02), +1).outcome, Outcome::holds);
  EXPECT_EQ(monotone("z", "rises", points(noisy, 0.02), -1).outcome, Outcome::fails);
}

TEST(Monotone, AStepDownBeyondTheErrorFailsWhateverTheSlope) {
  const Check check = monotone("z", "rises", points({4.3, 4.6, 4.2, 4.7, 4.8, 5}, 0.01), +1);
  EXPECT_EQ(check.outcome, Outcome::fails);
  EXPECT_NE(check.what.find("contradicting: from 1 to 2"), std::string::npos) << check.what;
}

TEST(Monotone, ALevelLineIsUndecidedAndNoneUnknown) {
  EXPECT_EQ(monotone("z", "rises", points({4.3, 4.31, 4.29, 4.3}, 0.02), +1).outcome, Outcome::undecided);
  EXPECT_EQ(monotone("z", "rises", {}, +1).outcome, Outcome::unknown);
}

TEST(Trends, TheLastIsSetAgainstEach) {
  const Family leads = leads_of_last(points({1, 5, 3}, 0.1));
  ASSERT_EQ(leads.size(), 2u);
  EXPECT_EQ(leads[1].name, "2 minus 1");
  EXPECT_DOUBLE_EQ(leads[1].value.value, -2);
}

}  // namespace
}  // namespace arenite::validation
