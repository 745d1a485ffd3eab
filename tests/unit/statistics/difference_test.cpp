#include "statistics/difference.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace arenite::statistics {
namespace {

TEST(Difference, HasTheErrorOfTwoSamplesThatKnowNothingOfEachOther) {
  // 3-4-5: variances add up.
  const Difference d = difference_of({1, 0.3}, {2.1, 0.4});
  EXPECT_DOUBLE_EQ(d.value, 1.1);
  EXPECT_DOUBLE_EQ(d.error, 0.5);
  EXPECT_DOUBLE_EQ(d.in_errors, 2.2);
  EXPECT_EQ(d.verdict, Verdict::beyond);
  EXPECT_EQ(difference_of({1, 0.3}, {1.9, 0.4}).verdict, Verdict::within);
}

TEST(Difference, IsNotJudgedWithoutErrors) {
  const Difference d = difference_of({1}, {2});
  EXPECT_EQ(d.verdict, Verdict::unjudged);
  EXPECT_TRUE(std::isnan(d.in_errors));
  EXPECT_EQ(difference_of({1, 0}, {2, 0}).verdict, Verdict::unjudged);
  EXPECT_EQ(difference_of({1}, {1}).verdict, Verdict::equal);
  EXPECT_EQ(difference_of({1, 0.1}, {}).verdict, Verdict::alone);
  EXPECT_DOUBLE_EQ(difference_of({1, 0.1}, {2}).error, 0.1);
}

TEST(Difference, OfAnglesGoesTheShorterWay) {
  EXPECT_DOUBLE_EQ(difference_of({179}, {1}, 180).value, 2);
  EXPECT_DOUBLE_EQ(difference_of({1}, {179}, 180).value, -2);
  EXPECT_DOUBLE_EQ(difference_of({59}, {1}, 60).value, 2);
  EXPECT_DOUBLE_EQ(difference_of({179}, {1}).value, -178);
}

TEST(Difference, OfEqualSamplesIsBeyondItsErrorAsOftenAsItIsTold) {
  RandomStream random(7, Purpose::test);
  constexpr std::size_t pairs = 100'000;
  const auto normal = [&] {
    double sum = -6;  // of twelve even numbers: mean 0, variance 1, tails thinner than a normal law's
    for (int k = 0; k < 12; ++k) sum += random.uniform();
    return sum;
  };
  std::size_t beyond = 0;
  for (std::size_t k = 0; k < pairs; ++k)
    beyond += difference_of({normal(), 1}, {normal(), 1}).verdict == Verdict::beyond;
  // 1 - 0.9545 of a normal law; sqrt(4550) = 67 is one deviation of the count. The tails of sums of 24 even numbers
  // shift it by kurtosis/24 He3(2) phi(2) 2 = 0.05/24 x 2 x 0.054 x 2, 45 of the count.
  EXPECT_NEAR(beyond_by_chance(pairs), 4550, 1);
  EXPECT_NEAR(static_cast<double>(beyond), beyond_by_chance(pairs), 4 * 67 + 45);
}

TEST(Difference, TheInverseHasTheSameRelativeError) {
  const Estimate inverse = inverse_of({-4, 0.5}, 10);
  EXPECT_DOUBLE_EQ(inverse.value, -2.5);
  EXPECT_DOUBLE_EQ(inverse.error, 2.5 * 0.125);
}

}  // namespace
}  // namespace arenite::statistics
