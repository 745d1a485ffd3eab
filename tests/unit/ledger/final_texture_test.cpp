#include "ledger/final_texture.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace arenite::ledger {
namespace {

std::vector<double> steps(int count, double first, double last) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(first + (last - first) * (i + 0.5) / count);
  return values;
}

TEST(ChanceOfOneLaw, IsOneForEqualSamplesAndSmallForShiftedOnes) {
  EXPECT_DOUBLE_EQ(chance_of_one_law(steps(200, 0, 1), steps(200, 0, 1)), 1);
  EXPECT_LT(chance_of_one_law(steps(200, 0, 1), steps(200, 0.3, 1.3)), 1e-6);
  EXPECT_TRUE(std::isnan(chance_of_one_law({}, {1})));
}

TEST(ChanceOfOneLaw, IsFivePercentAtTheCriticalDistance) {
  // D = 1.358 sqrt(2/n) is the tabled bound of 5 % for two large samples of n.
  const int n = 10000;
  EXPECT_NEAR(chance_of_one_law(steps(n, 0, 1), steps(n, 1.358 * std::sqrt(2.0 / n), 1 + 1.358 * std::sqrt(2.0 / n))), 0.05, 0.004);
}

}  // namespace
}  // namespace arenite::ledger
