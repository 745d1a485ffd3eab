#include "grains/fields/stage_numbers.hpp"

#include <gtest/gtest.h>

namespace arenite::fields {
namespace {

TEST(StageNumbers, AreThoseOfEveryStatistic) {
  StageResult result;
  Packing& packing = result.snapshots.emplace_back().packing;
  packing.materials = {{"glass", 2500, 1e6, 0}};
  packing.domain.wall[right].position = packing.domain.wall[top].position = 0.02;
  packing.grains.resize(2);
  packing.grains.radius = {0.005, 0.005};
  packing.grains.position = {{0.005, 0.005}, {0.015, 0.005}};
  packing.cohesive.push_back({0, 1, -1e-6, 0.4, 0});
  dem::Stage stage;
  stage.gravity = true;
  const Numbers numbers = stage_numbers({result, stage, nullptr, texture::measure(packing)});
  EXPECT_EQ(numbers["grains"].get<int>(), 2);
  EXPECT_EQ(numbers["surface"]["grains"].get<int>(), 2);
  EXPECT_EQ(numbers["cohesion"]["pairs"].get<int>(), 1);
}

}  // namespace
}  // namespace arenite::fields
