#include "core/decimals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace arenite {
namespace {

TEST(Decimals, OfSumsAndQuotientsAreThoseOneWouldWrite) {
  EXPECT_NE((0.15 - 0.04) / 2, 0.055);
  EXPECT_EQ(in_decimals((0.15 - 0.04) / 2, 0.15), 0.055);
  EXPECT_NE(0.105 - 0.1, 0.005);
  EXPECT_EQ(in_decimals(0.105 - 0.1, 0.105), 0.005);
  EXPECT_EQ(in_decimals(0.3 - 0.2 - 0.1, 0.3), 0);
  EXPECT_EQ(in_decimals(-0.30000000000000004, 0.1), -0.3);
}

TEST(Decimals, LeaveWhatHasNoneAsItIs) {
  EXPECT_EQ(in_decimals(0, 1), 0);
  EXPECT_EQ(in_decimals(0.0164, 0.0164), 0.0164);
  EXPECT_EQ(in_decimals(1.0 / 3, 1.0 / 3), 1.0 / 3);
  EXPECT_EQ(in_decimals(0.1 * std::sqrt(2), 1), 0.1 * std::sqrt(2));
  EXPECT_EQ(in_decimals(1e-60, 1e-60), 1e-60);
  const double endless = std::numeric_limits<double>::infinity();
  EXPECT_EQ(in_decimals(endless, endless), endless);
}

}  // namespace
}  // namespace arenite
