#include <gtest/gtest.h>

#include "solid/stress/grains.hpp"

using namespace arenite;

TEST(GrainMeans, AreOverTheNodesOfEachGrain) {
  PhaseMap map = make_phase_map(3, 2, 0.5);
  map.grain_class = {GrainClass::small, GrainClass::large, GrainClass::small};
  map.grain = {0, 0, -1, 1, -1, 0};
  for (std::size_t k = 0; k < 6; ++k) map.phase[k] = map.grain[k] < 0 ? Phase::matrix : Phase::particle;
  StressField field{3, 2, 0.5, {}, {}, {1, 2, 9, 4, 9, 6}, {10, 20, 90, 40, 90, 60}, {-1, -2, 9, -4, 9, -6}};
  const stress::GrainStresses means = stress::measure_grains(map, field, 0, 1);
  EXPECT_EQ(means.nodes, (std::vector<std::int64_t>{3, 1, 0}));
  EXPECT_DOUBLE_EQ(means.centre[0].x, (0.25 + 0.75 + 1.25) / 3);
  EXPECT_DOUBLE_EQ(means.centre[0].y, (0.25 + 0.25 + 0.75) / 3);
  EXPECT_DOUBLE_EQ(means.stress[0].xx, 3);
  EXPECT_DOUBLE_EQ(means.stress[0].yy, 30);
  EXPECT_DOUBLE_EQ(means.stress[1].xy, -4);
  EXPECT_DOUBLE_EQ(means.stress[2].yy, 0);
}

TEST(GrainMeans, OfAnUnloadedSampleHoldNoStress) {
  PhaseMap map = make_phase_map(2, 2, 1);
  map.grain_class = {GrainClass::none};
  const stress::GrainStresses means = stress::measure_grains(map, {}, 0, 1);
  EXPECT_EQ(means.nodes, (std::vector<std::int64_t>{0}));
  EXPECT_DOUBLE_EQ(means.stress[0].yy, 0);
}
