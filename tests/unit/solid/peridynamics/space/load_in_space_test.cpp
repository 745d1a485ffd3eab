#include "solid/peridynamics/space/load_in_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace arenite::peridynamics {
namespace {

VoxelMap block() {
  VoxelMap map = make_voxel_map(6, 6, 12, 1e-3);
  std::ranges::fill(map.phase, Phase::matrix);
  std::ranges::fill(map.grain, -1);
  return map;
}

void empty_layer(VoxelMap& map, int z) {
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) map.phase[map.index(x, y, z)] = Phase::empty;
}

TEST(LoadInSpace, ACutOfOneVoxelIsBridgedByBondsAlone) {
  VoxelMap map = block();
  EXPECT_FALSE(joined_through_voids_only(map));
  empty_layer(map, 6);
  EXPECT_TRUE(joined_through_voids_only(map));
  EXPECT_EQ(load(map, {}).report.ending, statics::Ending::solved) << "bonds of two spacings reach across";
  map.phase[map.index(2, 3, 6)] = Phase::matrix;
  EXPECT_FALSE(joined_through_voids_only(map));
}

TEST(LoadInSpace, VoxelsThatMeetInACornerAreJoinedBySolid) {
  VoxelMap map = make_voxel_map(4, 4, 4, 1e-3);
  std::ranges::fill(map.grain, -1);
  for (int k = 0; k < 4; ++k) map.phase[map.index(k, k, k)] = Phase::matrix;
  EXPECT_FALSE(joined_through_voids_only(map));
  map.phase[map.index(1, 1, 1)] = Phase::empty;
  EXPECT_TRUE(joined_through_voids_only(map));
}

}  // namespace
}  // namespace arenite::peridynamics
