#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "recipe/recipe.hpp"
#include "unit/recipe/glass_grains.hpp"

namespace arenite::recipe {
namespace {

const std::string between_membranes = R"([container]
width = "100 mm"
height = "200 mm"
thickness = "10 mm"
)" + testing::glass_grains +
                                      R"([membrane]
stiffness = "0.2 N/mm"
spacing = "1 mm"
ends = "held"
[[stages]]
name = "cell"
left = { membrane = "50 kPa" }
right = { membrane = "50 kPa" }
top = { pressure = "50 kPa" }
[[stages]]
name = "shear"
left = { membrane = "50 kPa" }
right = { membrane = "60 kPa" }
top = { velocity = "1 mm/s" }
duration = "1 s"
)";

/// What a recipe with this in the place of that is refused for; empty where it is read.
std::string refusal(const std::string& place, const std::string& text) {
  std::string changed = between_membranes;
  changed.replace(changed.find(place), place.size(), text);
  try {
    parse_recipe(changed, "membranes.toml");
  } catch (const InputError& error) { return error.what(); }
  return "";
}

bool is_refused(const std::string& place, const std::string& text, const std::string& sentence) {
  const std::string why = refusal(place, text);
  EXPECT_NE(why.find("membranes.toml:"), std::string::npos) << why;
  EXPECT_NE(why.find(sentence), std::string::npos) << why;
  return !why.empty();
}

TEST(MembranesInRecipes, AreReadAndWritten) {
  const Recipe recipe = parse_recipe(between_membranes, "membranes.toml");
  const Stage& shear = recipe.stages[1];
  EXPECT_EQ(membrane_pressures(shear)[right], 60e3);
  EXPECT_FALSE(membrane_pressures(shear)[top]);
  EXPECT_EQ(shear.skin.stiffness, 200);
  EXPECT_EQ(shear.skin.spacing, 1e-3);
  EXPECT_EQ(shear.skin.ends, dem::SkinEnds::held);
  EXPECT_EQ(parse_recipe(to_toml(recipe), "again.toml").stages, recipe.stages);
}

TEST(MembranesInRecipes, TakeATableOfPressureAndNothingElse) {
  const auto table = [](const std::string& of, const std::string& values) {
    return "duration = \"1 s\"\n[[stages.programmes]]\nof = \"" + of + "\"\ntable = " + values + "\n";
  };
  std::string changed = between_membranes;
  const std::string end = "duration = \"1 s\"\n";
  changed.replace(changed.rfind(end), end.size(), table("right.pressure", R"([["0 s", "60 kPa"], ["1 s", "90 kPa"]])"));
  const Recipe recipe = parse_recipe(changed, "membranes.toml");
  EXPECT_EQ(membrane_pressures(recipe.stages[1])[right], 60e3);
  EXPECT_EQ(recipe.stages[1].programmes.at(0).at(0.5), 75e3);
  EXPECT_EQ(parse_recipe(to_toml(recipe), "again.toml").stages, recipe.stages);
  EXPECT_TRUE(is_refused(end, table("right.force", R"([["0 s", "0 kN"], ["1 s", "1 kN"]])"), "right.pressure"));
}

TEST(MembranesInRecipes, ThatMakeNoSenseAreRefused) {
  EXPECT_TRUE(is_refused("thickness", "periodic_y = true\nthickness", "four walls"));
  EXPECT_TRUE(is_refused("[membrane]", "[integration]\nintegrator = \"gear5\"\n[membrane]", "need integration"));
  EXPECT_TRUE(is_refused("top = { pressure", "top = { membrane", "is a membrane itself"));
  EXPECT_TRUE(is_refused("top = { pressure = \"50 kPa\" }", "open = { top = true }", "one is open"));
  EXPECT_TRUE(is_refused("duration", "slide = { left = \"1 mm/s\" }\nduration", "neither slides"));
  EXPECT_TRUE(is_refused("left = { membrane = \"50 kPa\" }\nright = { membrane = \"60 kPa\" }",
                         "right = { membrane = \"60 kPa\" }", "from stage \"cell\" on"));
  EXPECT_TRUE(is_refused("duration = \"1 s\"", "duration = \"1 s\"\noutlets = [{ top = \"1 mm\" }]",
                         "leave inflow and outlets out, or give this side a pressure"));
  EXPECT_TRUE(is_refused("diameter = \"5 mm\"", "diameter = \"5 mm\"\nshape = \"pentagon\"", "cut into polygons"));
  EXPECT_TRUE(is_refused("[membrane]",
                         "[[boundaries]]\nname = \"left_membrane\"\npoints = [[\"0 mm\", \"0 mm\"], [\"1 mm\", "
                         "\"0 mm\"]]\n[membrane]",
                         "rename it"));
  EXPECT_TRUE(is_refused("0.2 N/mm", "-0.2 N/mm", "stiffness"));
}

TEST(MembranesInRecipes, LeaveNoTraceWhereThereAreNone) {
  const std::string plain = "[container]\nwidth = \"100 mm\"\nthickness = \"10 mm\"\n" + testing::glass_grains +
                            "[[stages]]\nname = \"load\"\ntop = { pressure = \"50 kPa\" }\n";
  EXPECT_EQ(to_toml(parse_recipe(plain, "plain.toml")).find("membrane"), std::string::npos);
}

}  // namespace
}  // namespace arenite::recipe
