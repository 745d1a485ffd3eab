#include <gtest/gtest.h>

#include "report/field_document.hpp"

using namespace arenite;

TEST(Thinning, LeavesASmallMapWhole) {
  const PhaseMap map = make_phase_map(7, 5, 1e-3);
  const report::Thinning kept(map, 35);
  EXPECT_EQ(kept.stride, 1);
  ASSERT_EQ(kept.node.size(), 35u);
  for (std::size_t k = 0; k < 35; ++k) EXPECT_EQ(kept.node[k], k);
}

TEST(Thinning, TakesEveryNthNodeFromTheMiddleOfTheFirstBlock) {
  const PhaseMap map = make_phase_map(13, 9, 1e-3);
  const report::Thinning kept(map, 12);
  EXPECT_EQ(kept.stride, 3);
  EXPECT_EQ(kept.width, 4);
  EXPECT_EQ(kept.height, 3);
  EXPECT_EQ(kept.node[0], map.index(1, 1));
  EXPECT_EQ(kept.node[5], map.index(4, 4));
  EXPECT_EQ(kept.node.back(), map.index(10, 7));
}

TEST(Thinning, OfAMapOfFourThousandSquaredKeepsAboutAMillionNodes) {
  const PhaseMap map = make_phase_map(4096, 4096, 1e-3);
  const report::Thinning kept(map);
  EXPECT_EQ(kept.stride, 4);
  EXPECT_EQ(kept.node.size(), 1024u * 1024u);
}
