#include "validation/results.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/validation/made_up_table.hpp"

namespace arenite::validation {
namespace {

Results two_ratios() {
  Results results;
  results.add("made-up", made_up_table({"ratio", "seed"}, {"z", "n"},
                                       {{{"2", "1"}, {4.5, 10}},
                                        {{"2", "2"}, {4.7, 20}},
                                        {{"1", "1"}, {4.0, 30}},
                                        {{"1", "2"}, {4.2}},
                                        {{"1", "3"}, {9, 9}, "failed"}}));
  return results;
}

TEST(Results, MeanIsOverRunsThatAreDoneAndHaveTheNumber) {
  const auto z = mean(two_ratios(), "made-up", "z", {{"ratio", "1.0"}});
  EXPECT_DOUBLE_EQ(z.value, 4.1);
  EXPECT_NEAR(z.error, 0.1, 1e-12);  // deviations of 0.1 each: sqrt(0.02 / 1 / 2)
  EXPECT_DOUBLE_EQ(mean(two_ratios(), "made-up", "n").value, 20);
}

TEST(Results, SeriesRisesInItsKey) {
  const Series z = series(two_ratios(), "made-up", swept("ratio"), "z");
  ASSERT_EQ(z.size(), 2u);
  EXPECT_EQ(z[0].x, 1);
  EXPECT_DOUBLE_EQ(z[1].mean, 4.6);
  EXPECT_EQ(z[1].runs, 2u);
}

TEST(Results, NumbersAreWorkedOutFromSeveral) {
  EXPECT_DOUBLE_EQ(mean(two_ratios(), "made-up", [](const validation::Run& run) { return run("z") * run.key("ratio"); },
                        {{"seed", "1"}})
                       .value,
                   (9.0 + 4.0) / 2);
}

TEST(Results, WhatIsNotThereIsUnknown) {
  EXPECT_TRUE(std::isnan(mean(two_ratios(), "made-up", "w").value));
  EXPECT_TRUE(std::isnan(mean(two_ratios(), "elsewhere", "z").value));
  EXPECT_TRUE(series(two_ratios(), "made-up", swept("width"), "z").empty());
  EXPECT_FALSE(two_ratios().study("made-up").complete());
}

}  // namespace
}  // namespace arenite::validation
