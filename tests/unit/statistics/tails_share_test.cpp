#include <gtest/gtest.h>

#include "statistics/tails.hpp"

namespace arenite::statistics {
namespace {

TEST(TailsShare, RoundingPutsNoEqualValueAboveTheThreshold) {
  EXPECT_EQ(share_beyond({1, 1 + 1e-15, 1 - 1e-15, 1}, 1), 0);
  EXPECT_EQ(share_beyond({-2 + 4e-16, -2, -3}, -2), 0);
  EXPECT_EQ(share_beyond({0.5, 1.5, 2, 1}, 1), 0.5);
}

}  // namespace
}  // namespace arenite::statistics
