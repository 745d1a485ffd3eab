#include "solid/statics/pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace arenite::statics {
namespace {

constexpr std::array<int, 3> count{48, 24, 20};
std::size_t index(int x, int y, int z) { return static_cast<std::size_t>(x + count[0] * (y + count[1] * z)); }

/// Labels where `is_inside` says so, -1 elsewhere.
template <class Inside> std::vector<std::int32_t> labelled(std::int32_t as, const Inside& is_inside) {
  std::vector<std::int32_t> label(static_cast<std::size_t>(count[0] * count[1] * count[2]), -1);
  for (int z = 0; z < count[2]; ++z)
    for (int y = 0; y < count[1]; ++y)
      for (int x = 0; x < count[0]; ++x)
        if (is_inside(x, y, z)) label[index(x, y, z)] = as;
  return label;
}

/// Two balls 16 voxels across, 20 apart, and a rod of 4 x 4 voxels between their centres.
bool is_dumbbell(int x, int y, int z) {
  const auto is_ball = [&](int middle) { return std::hypot(x - middle, y - 10, z - 10) <= 8; };
  return is_ball(13) || is_ball(33) || (x > 13 && x < 33 && std::abs(2 * y - 19) < 4 && std::abs(2 * z - 19) < 4);
}

TEST(Pieces, WhatReachesFarIsCutAtItsNeck) {
  auto label = labelled(2, is_dumbbell);
  const auto before = label;
  EXPECT_EQ(cut_at_necks(label, count, 2, 3), 4);
  EXPECT_NE(label[index(13, 10, 10)], label[index(33, 10, 10)]);
  int x = 13;  // the cut lies where the neck does
  while (label[index(x, 10, 10)] == label[index(13, 10, 10)]) ++x;
  EXPECT_GT(x, 19);
  EXPECT_LT(x, 28);
  for (std::size_t k = 0; k < label.size(); ++k) {
    if (before[k] == -1) EXPECT_EQ(label[k], -1);
    else EXPECT_TRUE(label[k] == 2 || label[k] == 3);
  }
}

TEST(Pieces, WhatIsConvexSmallOrOfAnotherLabelStaysWhole) {
  auto block = labelled(0, [](int, int y, int) { return y > 3; });
  const auto as_it_was = block;
  EXPECT_EQ(cut_at_necks(block, count, 0, 1), 1);
  EXPECT_EQ(block, as_it_was);
  auto other = labelled(5, is_dumbbell);
  EXPECT_EQ(cut_at_necks(other, count, 0, 5), 5);
  EXPECT_EQ(std::ranges::count(other, 5), std::ranges::count(labelled(5, is_dumbbell), 5));
  auto small = labelled(0, [](int x, int y, int z) { return x < 31 && is_dumbbell(x, y, z); });
  const auto short_of_it = small;
  EXPECT_EQ(cut_at_necks(small, count, 0, 1), 1);
  EXPECT_EQ(small, short_of_it);
}

}  // namespace
}  // namespace arenite::statics
