#include "ledger/trends.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace arenite::ledger {
namespace {

Series points(const std::vector<double>& y, double error) {
  Series all;
  for (std::size_t i = 0; i < y.size(); ++i) all.push_back({static_cast<double>(i), y[i], error, 5});
  return all;
}

TEST(Trends, SlopeOfALineIsItsSlopeWithTheErrorOfItsMeans) {
  const Value s = slope(points({1, 3, 5}, 0.1));
  EXPECT_DOUBLE_EQ(s.value, 2);
  EXPECT_NEAR(s.error, 0.1 / std::sqrt(2.0), 1e-12);  // sigma / sqrt(Sxx), Sxx = 2
  EXPECT_NEAR(line_r2(points({1, 3, 5}, 0.1)), 1, 1e-12);
}

TEST(Trends, SlopeWithoutErrorsTakesTheScatterAboutTheLine) {
  const Value s = slope(points({0, 1.1, 1.9, 3}, statistics::unknown));
  EXPECT_NEAR(s.value, 0.98, 1e-12);
  EXPECT_GT(s.error, 0);
}

TEST(Trends, RankCorrelationSeesOrderOnly) {
  EXPECT_NEAR(spearman(points({1, 10, 11, 1000}, 1)), 1, 1e-12);
  EXPECT_NEAR(spearman(points({9, 3, 2, 1}, 1)), -1, 1e-12);
}

TEST(Checks, HoldFailAndAreUnknown) {
  EXPECT_EQ(within("a", {1.05, 0.3}, 1, 0.1).holds, Holds::yes);
  EXPECT_EQ(within("a", {1.15, 0.3}, 1, 0.1).holds, Holds::no);
  EXPECT_EQ(within("a", {}, 1, 0.1).holds, Holds::unknown);
  EXPECT_EQ(positive("a", "", {1, 0.4}).holds, Holds::yes);
  EXPECT_EQ(positive("a", "", {1, 0.6}).holds, Holds::no);
  EXPECT_EQ(positive("a", "", {1}).holds, Holds::unknown);
  EXPECT_EQ(negative("a", "", {-1, 0.4}).holds, Holds::yes);
  EXPECT_EQ(none("a", "", {-1, 0.6}).holds, Holds::yes);
  EXPECT_EQ(none("a", "", {-1, 0.4}).holds, Holds::no);
  EXPECT_EQ(between("a", "", {2}, 1, 3).holds, Holds::yes);
  EXPECT_EQ(above("a", "", {2}, 2).holds, Holds::no);
  EXPECT_EQ(below("a", "", {1}, 2).holds, Holds::yes);
}

TEST(Values, ErrorsAddInSquares) {
  EXPECT_DOUBLE_EQ(difference({5, 0.3}, {3, 0.4}).error, 0.5);
  EXPECT_DOUBLE_EQ(ratio({6, 0.6}, {3, 0}).error, 0.2);
  EXPECT_TRUE(std::isnan(difference({5}, {3, 0.4}).error));
}

TEST(Trends, AVerdictIsToldByWhatIsKnownOfIt) {
  EXPECT_EQ(told("Law R", {{within("z", {4.2, 0.01}, 4.3, 0.2), positive("rise", "-", {}), above("share", "-", {0.1}, 0.5)}}),
            "Law R: z 4.2 +- 0.01 (holds); share 0.1 (fails).");
  EXPECT_EQ(told("Law R", {}), "");
}

}  // namespace
}  // namespace arenite::ledger
