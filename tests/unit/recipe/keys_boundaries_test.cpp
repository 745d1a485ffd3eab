#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "recipe/recipe.hpp"
#include "unit/recipe/glass_grains.hpp"

namespace arenite::recipe {
namespace {

const std::string hopper = R"(
[container]
width = "100 mm"
height = "200 mm"
thickness = "10 mm"
[packing]
area = { bottom = "60 mm" }
)" + testing::glass_grains +
                           R"([[boundaries]]
name = "floor"
points = [["0 mm", "50 mm"], ["40 mm", "5 cm"]]
[[boundaries]]
name = "drum"
closed = true
points = [["0 mm", "0 mm"], ["10 mm", "0 mm"], ["0 mm", "10 mm"]]
[[stages]]
name = "turn"
duration = "1 s"
count_below = "45 mm"
open = { right = true }
[[stages.boundaries]]
name = "floor"
absent = true
[[stages.boundaries]]
name = "drum"
velocity = ["0 mm/s", "100 mm/s"]
spin = "180 deg/s"
centre = ["1 mm", "2 mm"]
)";

std::string with(const std::string& from, const std::string& to) {
  std::string text = hopper;
  text.replace(text.find(from), from.size(), to);
  return text;
}

/// Whether the one problem of a recipe says this.
::testing::AssertionResult is_refused(const std::string& text, const std::string& part) {
  try {
    parse_recipe(text, "r.toml");
  } catch (const InputError& error) {
    const std::string what = error.what();
    if (error.problems().size() == 1 && what.find(part) != std::string::npos) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << what;
  }
  return ::testing::AssertionFailure() << "was read";
}

TEST(BoundariesInRecipes, AreReadAndWritten) {
  const Recipe recipe = parse_recipe(hopper, "r.toml");
  ASSERT_EQ(recipe.boundaries.size(), 2u);
  EXPECT_EQ(recipe.boundaries[0].points, (std::vector<Vec2>{{0, 0.05}, {0.04, 0.05}}));
  EXPECT_FALSE(recipe.boundaries[0].closed);
  EXPECT_TRUE(recipe.boundaries[1].closed);
  EXPECT_EQ(recipe.packing.area->edge[bottom], 0.06);
  const Stage& stage = recipe.stages[0];
  EXPECT_EQ(stage.open, (ByAnySide<bool>{false, true}));
  EXPECT_EQ(stage.count_below, 0.045);
  ASSERT_EQ(stage.boundaries.size(), 2u);
  EXPECT_TRUE(stage.boundaries[0].absent);
  EXPECT_EQ(stage.boundaries[1].velocity, (Vec2{0, 0.1}));
  EXPECT_DOUBLE_EQ(stage.boundaries[1].spin, std::numbers::pi);
  EXPECT_EQ(stage.boundaries[1].centre, (Vec2{0.001, 0.002}));
  EXPECT_TRUE(parse_recipe(to_toml(recipe), "r.toml") == recipe);
  const Recipe again = parse_recipe(to_commented_toml(recipe), "r.toml");
  EXPECT_EQ(again.boundaries, recipe.boundaries);
  EXPECT_EQ(again.stages, recipe.stages);
}

TEST(BoundariesInRecipes, ThatMakeNoSenseAreRefused) {
  EXPECT_TRUE(is_refused(with(R"(["0 mm", "50 mm"], )", ""), "must be two or more"));
  EXPECT_TRUE(is_refused(with(R"(["40 mm", "5 cm"])", R"(["0 mm", "50 mm"])"), "must differ from the one before"));
  EXPECT_TRUE(is_refused(with(R"(["40 mm", "5 cm"])", R"(["40 mm"])"), "two numbers"));
  EXPECT_TRUE(is_refused(with(R"("40 mm", "5 cm")", R"("40 mm", 50)"), "has no unit"));
  EXPECT_TRUE(
      is_refused(with("name = \"drum\"\nvelocity", "name = \"gate\"\nvelocity"), "there is no boundary \"gate\""));
  EXPECT_TRUE(is_refused(with("name = \"drum\"\nvelocity", "name = \"floor\"\nvelocity"), "named twice"));
  EXPECT_TRUE(is_refused(
      with("[[stages]]\n",
           "[[boundaries]]\nname = \"left\"\npoints = [[\"0 mm\", \"0 mm\"], [\"1 mm\", \"0 mm\"]]\n[[stages]]\n"),
      "not be that of a wall"));
  EXPECT_TRUE(is_refused(with("duration = \"1 s\"\n", ""), "moving side or boundary"));
  EXPECT_TRUE(is_refused(with("open = {", "right = { velocity = \"1 mm/s\" }\nopen = {"), "cannot be open and move"));
  EXPECT_TRUE(is_refused(with("bottom = \"60 mm\"", "bottom = \"600 mm\""), "must lie in the container"));
}

TEST(BoundariesInRecipes, AreDrivenByTablesAndForces) {
  const auto table = [&](const std::string& of, const std::string& value, const std::string& motion = "") {
    std::string text = hopper;
    text.replace(text.find("velocity = ["), text.find("centre = [") - text.find("velocity = ["), motion);
    return text + "[[stages.programmes]]\nof = \"" + of + "\"\nboundary = \"drum\"\ntable = [[\"0 s\", \"" + value +
           "\"], [\"1 s\", \"" + value + "\"]]\n";
  };
  const Recipe placed = parse_recipe(table("boundary.y", "3 mm"), "r.toml");
  ASSERT_EQ(placed.stages[0].programmes.size(), 1U);
  EXPECT_EQ(placed.stages[0].programmes[0].name, "drum");
  EXPECT_EQ(placed.stages[0].programmes[0].of.way(), 1);
  EXPECT_EQ(placed.stages[0].programmes[0].table[0].y, 0.003);
  EXPECT_TRUE(parse_recipe(to_toml(placed), "r.toml") == placed);
  const Recipe pushed =
      parse_recipe(table("boundary.force_x", "3 N", "mass = \"2 kg\"\nforce = [\"0 N\", \"1 N\"]\n"), "r.toml");
  EXPECT_EQ(pushed.stages[0].boundaries[1].mass, 2);
  EXPECT_EQ(pushed.stages[0].boundaries[1].force, (Vec2{0, 1}));
  EXPECT_TRUE(parse_recipe(to_toml(pushed), "r.toml") == pushed);
  EXPECT_TRUE(is_refused(table("boundary.force_x", "3 N", "mass = \"2 kg\"\nforce = [\"1 N\", \"0 N\"]\n"),
                         "along this axis is already prescribed"));
  EXPECT_TRUE(is_refused(table("boundary.force_z", "3 N", "mass = \"2 kg\"\n"), "is of samples in space"));
  EXPECT_TRUE(is_refused(table("boundary.force_x", "3 N"), "only a boundary with a mass"));
  EXPECT_TRUE(is_refused(table("boundary.y", "3 mm", "mass = \"2 kg\"\n"), "has a mass in this stage"));
  EXPECT_TRUE(is_refused(table("boundary.y", "3 mm", "velocity = [\"0 mm/s\", \"1 mm/s\"]\n"),
                         "is already prescribed in this stage"));
  EXPECT_TRUE(
      is_refused(table("boundary.y", "3 mm", "force = [\"0 N\", \"1 N\"]\n"), "moves only a boundary with a mass"));
}

TEST(BoundariesInRecipes, MayBeInAPeriodicContainerThatStays) {
  const std::string periodic = with("thickness", "periodic_x = true\nthickness");
  const auto closed = [&](const std::string& with_this) {
    std::string text = periodic;
    text.replace(text.find("open = { right = true }"), std::string("open = { right = true }").size(), with_this);
    return text;
  };
  EXPECT_TRUE(parse_recipe(closed(""), "r.toml").container.periodic[0]);
  EXPECT_TRUE(is_refused(closed("right = { velocity = \"1 mm/s\" }"), "is periodic and cannot move"));
}

TEST(BoundariesInRecipes, OfSpaceChangeARecipeByTheirOwnKeys) {
  Recipe still;
  still.dimension = 3;
  auto& plate = still.boundaries_in_space.emplace_back();
  plate.name = "plate";
  plate.points = {{0.01, 0.02, 0.03}, {0.04, 0.02, 0.03}, {0.04, 0.02, 0.06}};
  plate.corners = {0, 1, 2};
  still.stages.emplace_back().boundaries_in_space.emplace_back().name = "plate";
  Recipe turning = still;
  turning.stages[0].boundaries_in_space[0].spin = {0, 1, 0};
  EXPECT_NE(changed_keys(still).find("boundaries.0.corners = [[\"10 mm\", "), std::string::npos) << changed_keys(still);
  EXPECT_EQ(changed_keys(still).find("spin"), std::string::npos) << changed_keys(still);
  EXPECT_NE(changed_keys(turning).find("stages.0.boundaries.0.spin = "), std::string::npos) << changed_keys(turning);
}

TEST(BoundariesInRecipes, LeaveNoTraceWhereThereAreNone) {
  std::string text = hopper;
  text = text.substr(0, text.find("[[boundaries]]")) + "[[stages]]\nname = \"rest\"\n";
  text.replace(text.find("area"), std::string("area = { bottom = \"60 mm\" }").size(), "");
  const std::string written = to_toml(parse_recipe(text, "r.toml"));
  for (const char* key : {"boundaries", "open", "count_below", "area"})
    EXPECT_EQ(written.find(key), std::string::npos) << key;
}

}  // namespace
}  // namespace arenite::recipe
