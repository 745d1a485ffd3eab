#include "recipe/doubts.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "unit/recipe/smallest_recipe.hpp"

namespace arenite::recipe {
namespace {

Recipe with_stage(const std::string& stage, const std::string& more = "") {
  return parse_recipe(smallest + more + "[[stages]]\nname = \"test\"\n" + stage, "r.toml");
}
constexpr const char* biaxial =
    "right = { pressure = \"10 kPa\" }\ntop = { velocity = \"1 mm/s\" }\nduration = \"1 s\"\n";

TEST(Doubts, PlatensThatRubAreSaid) {
  const Recipe rubbing = with_stage(biaxial, "[contact]\nfriction = 0.5\n");
  ASSERT_EQ(doubts_of(rubbing).size(), 1u);
  EXPECT_NE(doubts_of(rubbing)[0].find("contact.wall_friction = 0"), std::string::npos);
  EXPECT_EQ(rubbing.notices, doubts_of(rubbing));
  EXPECT_TRUE(doubts_of(with_stage(biaxial, "[contact]\nfriction = 0.5\nwall_friction = 0\n")).empty());
  EXPECT_TRUE(doubts_of(with_stage("top = { pressure = \"10 kPa\" }\n", "[contact]\nfriction = 0.5\n")).empty());
}

TEST(Doubts, StagesThatMayNotEndAreSaid) {
  for (const auto& [stage, key] : {std::pair{"gravity = true\nopen = { right = true }\n", "duration"},
                                   {"top = { pressure = \"0 kPa\" }\n", "stages.test.top"},
                                   {"top = { pressure = \"1 kPa\" }\nsnapshots = 10\n", "stages.test.snapshots"}}) {
    const auto doubts = doubts_of(with_stage(stage));
    ASSERT_EQ(doubts.size(), 1u) << stage;
    EXPECT_NE(doubts[0].find(key), std::string::npos) << doubts[0];
    EXPECT_TRUE(doubts_of(with_stage(std::string(stage) + "duration = \"1 s\"\n")).empty());
  }
}

TEST(Stages, CyclesAreOfForceOrOfPressure) {
  const auto cycles = with_stage(
      "top = { pressure = \"1 kPa\" }\ncycles = { side = \"top\", min_pressure = \"1 kPa\", "
      "max_pressure = \"2 kPa\", count = 3 }\n");
  EXPECT_TRUE(cycles.stages[1].cycles->of_pressure);
  EXPECT_EQ(cycles.stages[1].cycles->max, 2000);
  EXPECT_EQ(parse_recipe(to_toml(cycles), "r.toml"), cycles);
  EXPECT_THROW(
      with_stage(
          "top = { pressure = \"1 kPa\" }\ncycles = { side = \"top\", min = \"1 N\", max = \"2 N\", count = 3 }\n"),
      InputError);
  EXPECT_THROW(
      with_stage("top = { pressure = \"1 kPa\" }\ncycles = { side = \"top\", min = \"1 N\", max_pressure = \"2 kPa\", "
                 "count = 3 }\n"),
      InputError);
}

}  // namespace
}  // namespace arenite::recipe
