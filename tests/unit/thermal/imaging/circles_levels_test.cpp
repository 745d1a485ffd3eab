#include <gtest/gtest.h>

#include "support/drawn_picture.hpp"
#include "thermal/imaging/circles.hpp"

namespace {
using namespace arenite;
using namespace arenite::test;

TEST(GreyLevels, BetweenBlackAndWhiteDisks) {
  const std::vector<DrawnDisk> disks{{30, 30, 15, 0.9, 0}, {70, 30, 15, 0.1, 1}};
  const auto levels =
      imaging::levels_between(draw(disks, {.width = 100, .height = 60, .background = 0.5, .noise = 0.01}));
  ASSERT_EQ(levels.size(), 1u);
  EXPECT_NEAR(levels.front(), 0.5, 0.01);
}

TEST(GreyLevels, NoneBetweenTwo) {
  const std::vector<DrawnDisk> disks{{30, 30, 15, 0.9, 0}, {70, 30, 15, 0.9, 1}};
  EXPECT_TRUE(
      imaging::levels_between(draw(disks, {.width = 100, .height = 60, .background = 0.5, .noise = 0.01})).empty());
  EXPECT_TRUE(imaging::levels_between({2, 1, {1, 1}}).empty());
  EXPECT_TRUE(imaging::levels_between({}).empty());
}

}  // namespace
