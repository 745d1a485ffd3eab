#include "validation/value.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace arenite::validation {
namespace {

TEST(Values, ErrorsAddInSquares) {
  EXPECT_DOUBLE_EQ(difference({5, 0.3}, {3, 0.4}).error, 0.5);
  EXPECT_DOUBLE_EQ(ratio({6, 0.6}, {3, 0}).error, 0.2);
  EXPECT_TRUE(std::isnan(difference({5}, {3, 0.4}).error));
}

TEST(Values, FreedomOfADifferenceIsWelchs) {
  EXPECT_NEAR(difference({5, 0.3, 4}, {3, 0.3, 4}).freedom, 8, 1e-12);
  EXPECT_NEAR(difference({5, 0.3, 4}, {3, 0, 1}).freedom, 4, 1e-12) << "a number without error takes none";
  EXPECT_NEAR(difference({5, 1, 1}, {3, 0.1, 9}).freedom, 1.01 * 1.01 / (1 + 1e-4 / 9), 1e-9);
}

TEST(Values, TheIntervalIsStudents) {
  // Tables: 12.706, 4.303 and 2.776 standard errors for 2, 3 and 5 samples.
  EXPECT_NEAR(half_interval({0, 1, 1}), 12.706, 1e-3);
  EXPECT_NEAR(half_interval({0, 1, 2}), 4.303, 1e-3);
  EXPECT_NEAR(half_interval({0, 1, 4}), 2.776, 1e-3);
  EXPECT_NEAR(half_interval({0, 1}), 1.960, 1e-3);
  EXPECT_EQ(half_interval({7, 0, 1}), 0);
  EXPECT_TRUE(std::isnan(half_interval({7})));
  EXPECT_NEAR(chance_above({2.776, 1, 4}, 0), 0.025, 1e-4);
}

TEST(Values, ZeroGivesOneAsFarAsTablesSay) {
  EXPECT_NEAR(chance_of_zero({-2.776, 1, 4}), 0.05, 1e-4);
  EXPECT_NEAR(chance_of_zero({2.776, 1, 4}), 0.05, 1e-4);
  EXPECT_EQ(chance_of_zero({0, 0, 4}), 1);
  EXPECT_EQ(chance_of_zero({1e-17, 1e-19, 4}), 1) << "rounding is no trace";
  EXPECT_EQ(chance_of_zero({1, 0, 4}), 0);
}

TEST(Values, AreTextWithTwoDigitsOfTheError) {
  EXPECT_EQ(text_of({3.63904, 0.0062}), "3.6390 +- 0.0062");
  EXPECT_EQ(text_of({3.6, 0.0996}), "3.60 +- 0.10");
  EXPECT_EQ(text_of({1385.2, 231}), "1390 +- 230");
  EXPECT_EQ(text_of({-0.064, 0.0226}), "-0.064 +- 0.023");
  EXPECT_EQ(text_of({93.62, 3.4}), "93.6 +- 3.4");
  EXPECT_EQ(text_of({0.5, statistics::unknown}), "0.5");
  EXPECT_EQ(text_of({-7, 0}), "-7");
  EXPECT_EQ(text_of({2.067e-17, 1.3e-19}), "0") << "what rounding leaves is zero";
  EXPECT_EQ(text_of({3.2e-14, 5.1e-14}), "0");
  EXPECT_EQ(text_of({}), "not known");
}

}  // namespace
}  // namespace arenite::validation
