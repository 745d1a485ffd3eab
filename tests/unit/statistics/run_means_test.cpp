#include "statistics/run_means.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/numbers_of.hpp"

namespace arenite::statistics {
namespace {

TEST(RunMeans, DensitiesAreMeansOverRuns) {
  const auto even = mean_density(test::numbers_of({R"({"a":{"pdf":{"low":0,"width":0.5,"density":[1,3]}}})",
                                                   R"({"a":{"pdf":{"low":0,"width":0.5,"density":[2,4]}}})", "{}"}),
                                 "a.pdf");
  EXPECT_EQ(even.x, (std::vector<double>{0.25, 0.75}));
  EXPECT_EQ(even.y, (std::vector<double>{1.5, 3.5}));
  EXPECT_DOUBLE_EQ(even.error[0], 0.5);
  const auto own = mean_density(
      test::numbers_of({R"({"pdf":{"edge":[1,10,100],"density":[2,1]}})", R"({"pdf":{"edge":[1,100],"density":[4]}})"}),
      "pdf");
  ASSERT_EQ(own.x.size(), 40u);
  EXPECT_DOUBLE_EQ(own.y.front(), 3);
  EXPECT_DOUBLE_EQ(own.y.back(), 2.5);
  EXPECT_TRUE(mean_density(test::numbers_of({"", "{}"}), "pdf").x.empty());
}

TEST(RunMeans, DensitiesByMiddlesOfBinsShareTheLongest) {
  const auto mean = mean_density(
      test::numbers_of({R"({"pdf":{"x":[0.05,0.15],"y":[4,2]}})", R"({"pdf":{"x":[0.05,0.15,0.25],"y":[2,2,6]}})"}),
      "pdf");
  ASSERT_EQ(mean.x.size(), 3u);
  EXPECT_NEAR(mean.x[2], 0.25, 1e-12);
  EXPECT_EQ(mean.y, (std::vector<double>{3, 2, 3}));
}

TEST(RunMeans, ListsAreMeansAgainstAnotherListOrSharesOfSectors) {
  const std::vector<Numbers> runs =
      test::numbers_of({R"({"a":{"s":[0.1,0.2],"m":[1,2]}})", R"({"a":{"s":[0.1,0.2],"m":[3,6]}})", "{}"});
  const auto list = mean_list(runs, "a.s", "a.m");
  EXPECT_EQ(list.x, (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(list.y, (std::vector<double>{2, 4}));
  EXPECT_DOUBLE_EQ(list.error[0], 1);
  const auto sectors = mean_list(runs, "", "a.m");
  EXPECT_EQ(sectors.x, (std::vector<double>{45, 135}));
  EXPECT_NEAR(sectors.y[0], 2.0 / 3, 1e-12);
  EXPECT_NEAR(sectors.y[1], 4.0 / 3, 1e-12);
}

TEST(RunMeans, TheShareAboveADensityStandsAtTheLowerEdgesWithTheErrorOfTheSharesOfTheSamples) {
  const auto above = mean_survival(test::numbers_of({R"({"pdf":{"low":0,"width":0.5,"density":[0.8,0.8,0.4]}})",
                                                     R"({"pdf":{"low":0,"width":0.5,"density":[1.2,0.8]}})"}),
                                   "pdf");
  EXPECT_EQ(above.x, (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(above.samples, 2u);
  ASSERT_EQ(above.y.size(), 3u);
  EXPECT_DOUBLE_EQ(above.y[0], 1);
  EXPECT_DOUBLE_EQ(above.y[1], 0.5);
  EXPECT_DOUBLE_EQ(above.y[2], 0.1);
  EXPECT_NEAR(above.error[0], 0, 1e-15);
  EXPECT_DOUBLE_EQ(above.error[1], 0.1);
  EXPECT_DOUBLE_EQ(above.error[2], 0.1);
}

TEST(RunMeans, RosesShowNumbersWithTheirErrorsAndShareSectorsOut) {
  const std::vector<Numbers> runs = test::numbers_of({R"({"s":[3,6,9]})", R"({"s":[5,6,7]})"});
  const auto counts = mean_list(runs, "", "s", {0, false});
  EXPECT_EQ(counts.y, (std::vector<double>{4, 6, 8}));
  EXPECT_DOUBLE_EQ(counts.error[0], 1);
  EXPECT_EQ(counts.samples, 2u);
  const auto two = mean_list(runs, "", "s", {2, false});
  EXPECT_EQ(two.x, (std::vector<double>{45, 135}));
  EXPECT_NEAR(two.y[0], 7, 1e-12);
  EXPECT_NEAR(two.y[1], 11, 1e-12);
  EXPECT_NEAR(two.error[0], 1, 1e-12);
  const auto four = mean_list(test::numbers_of({R"({"s":[3,6,9]})"}), "", "s", {4, false});
  EXPECT_NEAR(four.y[0] + four.y[1] + four.y[2] + four.y[3], 18, 1e-12);
  EXPECT_NEAR(four.y[1], 0.75 + 3, 1e-12);
}

TEST(RunMeans, ATailKeepsItsSlopeAndPassesThroughTheDensityInItsLogarithm) {
  Curve density;  // 5 exp(-2 x) times and over 1.1 by turns: the level that fits its logarithm is 5
  for (int k = 0; k < 40; ++k) {
    density.x.push_back(0.05 + 0.1 * k);
    density.y.push_back(5 * std::exp(-2 * density.x.back()) * (k % 2 == 0 ? 1.1 : 1 / 1.1));
  }
  const auto runs = test::numbers_of({R"({"tail":{"slope":{"value":1.5},"low":1,"high":3}})",
                                      R"({"tail":{"slope":{"value":2.5},"low":1,"high":3}})", "{}"});
  const Curve line = tail_line(runs, "tail", density);
  ASSERT_EQ(line.x, (std::vector<double>{1, 3}));
  EXPECT_NEAR(line.y[0], 5 * std::exp(-2.0), 1e-12);
  EXPECT_NEAR(line.y[1], 5 * std::exp(-6.0), 1e-12);
  EXPECT_TRUE(tail_line(runs, "none", density).x.empty());
}

}  // namespace
}  // namespace arenite::statistics
