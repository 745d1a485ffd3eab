#include <gtest/gtest.h>

#include <limits>

#include "statistics/numbers_text.hpp"

namespace arenite::statistics {
namespace {

TEST(WithError, GivesTheErrorTwoDigitsAndTheValueTheSamePlace) {
  EXPECT_EQ(with_error({1.23456, 0.0123}), "1.235 +- 0.012");
  EXPECT_EQ(with_error({-1234.5, 56.7}), "-1234 +- 57");
  EXPECT_EQ(with_error({2.5e6, 1.25e5}), "2.5e+06 +- 1.2e+05");
  EXPECT_EQ(with_error({2.5e6, 1.25e5}, 1e-6), "2.50 +- 0.12");
}

TEST(WithError, AnErrorOfRoundingIsNone) {
  EXPECT_EQ(with_error({1, 7e-16}), "1");
  EXPECT_EQ(with_error({-1, 7e-16}, 1e-6), "-1e-06");
  EXPECT_EQ(with_error({0, 0}), "0");
  EXPECT_EQ(with_error({1, 1e-11}), "1 +- 1e-11");
  EXPECT_EQ(with_error({1e-9, 1e-11}), "1e-09 +- 1e-11");
}

TEST(WithError, AnErrorThatIsNotKnownIsLeftOut) {
  EXPECT_EQ(with_error({1.5, std::numeric_limits<double>::quiet_NaN()}), "1.5");
}

}  // namespace
}  // namespace arenite::statistics
