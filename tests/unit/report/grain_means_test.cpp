#include "report/grain_means.hpp"

#include <gtest/gtest.h>

using namespace arenite;

TEST(GrainMeans, AreOverTheNodesOfEachGrain) {
  PhaseMap map = make_phase_map(3, 2, 0.5);
  map.grain_class = {GrainClass::small, GrainClass::large, GrainClass::small};
  map.grain = {0, 0, -1, 1, -1, 0};
  for (std::size_t k = 0; k < 6; ++k) map.phase[k] = map.grain[k] < 0 ? Phase::matrix : Phase::particle;
  StressField field{3, 2, 0.5, {}, {}, {1, 2, 9, 4, 9, 6}, {10, 20, 90, 40, 90, 60}, {-1, -2, 9, -4, 9, -6}};
  const report::GrainMeans means = report::grain_means(map, field);
  EXPECT_EQ(means.nodes, (std::vector<std::uint32_t>{3, 1, 0}));
  EXPECT_DOUBLE_EQ(means.x[0], (0.25 + 0.75 + 1.25) / 3);
  EXPECT_DOUBLE_EQ(means.y[0], (0.25 + 0.25 + 0.75) / 3);
  EXPECT_DOUBLE_EQ(means.xx[0], 3);
  EXPECT_DOUBLE_EQ(means.yy[0], 30);
  EXPECT_DOUBLE_EQ(means.xy[1], -4);
  EXPECT_DOUBLE_EQ(means.yy[2], 0);
}

TEST(GrainMeans, OfAnUnloadedSampleHoldNoStress) {
  PhaseMap map = make_phase_map(2, 2, 1);
  map.grain_class = {GrainClass::none};
  const report::GrainMeans means = report::grain_means(map, {});
  EXPECT_TRUE(means.yy.empty());
  EXPECT_EQ(means.nodes.size(), 1u);
}
