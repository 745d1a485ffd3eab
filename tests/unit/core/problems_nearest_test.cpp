#include "core/problems.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace arenite {
namespace {

TEST(EditDistance, CountsSingleLetterSlips) {
  EXPECT_EQ(edit_distance("friction", "friction"), 0u);
  EXPECT_EQ(edit_distance("frction", "friction"), 1u);
  EXPECT_EQ(edit_distance("fricttion", "friction"), 1u);
  EXPECT_EQ(edit_distance("friktion", "friction"), 1u);
  EXPECT_EQ(edit_distance("firction", "friction"), 1u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
}

TEST(EditDistance, IsSymmetricAndAtMostTheLongerLength) {
  EXPECT_TRUE(rc::check("symmetry and bound", [](const std::string& a, const std::string& b) {
    RC_ASSERT(edit_distance(a, b) == edit_distance(b, a));
    RC_ASSERT(edit_distance(a, b) <= std::max(a.size(), b.size()));
    RC_ASSERT((edit_distance(a, b) == 0) == (a == b));
  }));
}

TEST(Nearest, OffersWhatASlipCouldHaveMeantAndNothingElse) {
  const std::vector<std::string> keys{"width", "height", "thickness"};
  EXPECT_EQ(nearest("widht", keys), "width");
  EXPECT_EQ(nearest("Height", keys), "height");
  EXPECT_EQ(nearest("colour", keys), "");
  EXPECT_EQ(nearest("", keys), "");
  EXPECT_EQ(nearest(std::string(1000, 'w'), keys), "");
}

}  // namespace
}  // namespace arenite
