#include "report/figures/live_figures.hpp"

#include <gtest/gtest.h>

#include <string>

namespace arenite::report::figures {
namespace {

StageResult stage_of(std::size_t grains) {
  StageResult stage;
  Packing& packing = stage.snapshots.emplace_back().packing;
  packing.materials = {{}};
  packing.grains.resize(grains);
  packing.grains.radius.assign(grains, 0.5);
  return stage;
}

TEST(LiveFigures, AreThePictureOfAStateAndNoneWithoutOne) {
  EXPECT_EQ(live_figures({}, nullptr).size(), 0u);
  const Numbers few = live_figures(stage_of(3), nullptr);
  EXPECT_EQ(few[0]["sample"]["x"].size(), 3u);
}

TEST(LiveFigures, SayThatTooManyGrainsAreNotDrawn) {
  const Numbers many = live_figures(stage_of(20'001), nullptr);
  EXPECT_FALSE(many[0].contains("sample"));
  EXPECT_FALSE(many[0]["missing"].get<std::string>().empty());
}

TEST(LiveFigures, OfSpheresHaveTheStateOfNowWithItsArraysBeside) {
  SphereResult stage;
  EXPECT_EQ(live_figures(stage).size(), 0u);
  PackingIn<3>& packing = stage.snapshots.emplace_back().packing;
  packing.materials = {{}};
  packing.grains.resize(3);
  packing.grains.radius.assign(3, 0.5);
  const Numbers few = live_figures(stage);
  const Numbers& states = few[0]["spheres"]["states"];
  ASSERT_EQ(states.size(), 1u);
  EXPECT_EQ(states[0]["radius"]["n"].get<int>(), 3);
  EXPECT_FALSE(few[0]["block"].get<std::string>().empty());
}

}  // namespace
}  // namespace arenite::report::figures
