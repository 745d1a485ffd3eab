#include "solid/grid/thin_voids.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>

namespace arenite::grid {
namespace {

PhaseMap plate(int side, const std::function<bool(int, int)>& is_void) {
  PhaseMap map;
  map.width = map.height = side;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      map.phase.push_back(is_void(x, y) ? Phase::empty : Phase::matrix);
      map.grain.push_back(-1);
    }
  return map;
}

TEST(ThinVoids, ACrackIsAsLongAsItReaches) {
  EXPECT_EQ(longest_thin_void(plate(100, [](int, int) { return false; }), 2), 0);
  EXPECT_EQ(longest_thin_void(plate(100, [](int x, int y) { return y == 50 && x < 90; }), 2), 90);
  EXPECT_EQ(longest_thin_void(plate(100, [](int x, int y) { return (y == 50 || y == 51) && x < 90; }), 2), 90);
  EXPECT_EQ(longest_thin_void(plate(100, [](int x, int y) { return x == y && x >= 10 && x < 60; }), 2), 50)
      << "oblique, through corners";
}

TEST(ThinVoids, WhatIsWideIsNone) {
  EXPECT_LE(longest_thin_void(plate(100, [](int x, int y) { return y >= 50 && y < 53 && x >= 20 && x < 60; }), 2), 3)
      << "its corners alone";
  const auto hole = [](int x, int y) { return (x - 50) * (x - 50) + (y - 50) * (y - 50) < 400; };
  EXPECT_LE(longest_thin_void(plate(100, hole), 2), 4) << "a hole of 40 nodes: its blunt ends alone";
  EXPECT_EQ(longest_thin_void(plate(100, [](int x, int) { return x == 99; }), 2), 0) << "the sample's own edge";
}

TEST(ThinVoids, WedgesBetweenDisksThatTouchAreShort) {
  const auto outside = [](int x, int y) {
    const auto within = [&](double cx) { return (x - cx) * (x - cx) + (y - 50.0) * (y - 50.0) < 25 * 25; };
    return !within(25) && !within(74);
  };
  EXPECT_LE(longest_thin_void(plate(100, outside), 2), 10);
}

TEST(ThinVoids, GapsAroundContactsOfSpheresAreShortThoughTheyHangTogether) {
  VoxelMap map = make_voxel_map(60, 60, 60, 1);
  for (int z = 0; z < 60; ++z)
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 60; ++x) {
        const auto from_centre = [](int k) { return k % 20 - 9.5; };  // a cubic packing
        const double square =
            from_centre(x) * from_centre(x) + from_centre(y) * from_centre(y) + from_centre(z) * from_centre(z);
        map.phase[map.index(x, y, z)] = square < 10.2 * 10.2 ? Phase::matrix : Phase::empty;
      }
  const int length = longest_thin_void(map, 2);
  EXPECT_GE(length, 1);
  EXPECT_LE(length, 10);
}

TEST(ThinVoids, ACrackFromAHoleIsAsLongAsItIsDeep) {
  const auto hole_and_crack = [](int x, int y) {
    return (x - 20) * (x - 20) + (y - 50) * (y - 50) < 100 || (y == 50 && x >= 20 && x < 80);
  };
  EXPECT_NEAR(longest_thin_void(plate(100, hole_and_crack), 2), 50, 2);
}

TEST(ThinVoids, InSpaceASheetIsAsLongAsItsLongerSide) {
  VoxelMap map = make_voxel_map(20, 20, 20, 1);
  for (auto& phase : map.phase) phase = Phase::matrix;
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 17; ++x) map.phase[map.index(x, y, 10)] = Phase::empty;
  EXPECT_EQ(longest_thin_void(map, 2), 17);
  EXPECT_EQ(longest_thin_void(map, 1), 17);
}

}  // namespace
}  // namespace arenite::grid
