#include "core/parameters.hpp"

#include <gtest/gtest.h>

namespace arenite {
namespace {

TEST(Range, ContainsItsEndsUnlessExcluded) {
  EXPECT_FALSE(range::positive.contains(0));
  EXPECT_TRUE(range::positive.contains(1e-300));
  EXPECT_TRUE(range::not_negative.contains(0));
  EXPECT_FALSE(range::not_negative.contains(-1e-300));
  EXPECT_TRUE(range::above(0, 1).contains(1));
  EXPECT_FALSE(range::above(0, 1).contains(1.0000001));
  EXPECT_TRUE(range::any.contains(-1e300));
}

TEST(Range, IsNamedInTheUnitOfItsKey) {
  EXPECT_EQ(to_string(range::positive, "mm"), "above 0 mm");
  EXPECT_EQ(to_string(range::between(0.001, 0.5), "mm"), "from 1 mm to 500 mm");
  EXPECT_EQ(to_string(range::above(0, 1), ""), "above 0, up to 1");
  EXPECT_EQ(to_string(range::any, "mm"), "");
  EXPECT_EQ(to_string(IntegerRange{1, 10}), "from 1 to 10");
  EXPECT_EQ(to_string(IntegerRange{0}), "at least 0");
}

}  // namespace
}  // namespace arenite
