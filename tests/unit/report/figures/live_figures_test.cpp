#include "report/figures/live_figures.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace arenite::report::figures
