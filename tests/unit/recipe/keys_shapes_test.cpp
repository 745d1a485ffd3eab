#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "recipe/recipe.hpp"
#include "unit/recipe/glass_grains.hpp"

namespace arenite::recipe {
namespace {

const std::string head = R"([container]
width = "100 mm"
thickness = "10 mm"
)" + testing::glass_grains;
const std::string stage = "[[stages]]\nname = \"rest\"\n";

/// Whether a recipe of grains of this shape has one problem that names the line and says this; lines count from the
/// shape's first.
::testing::AssertionResult is_refused(const std::string& shape, int line, const std::string& part,
                                      const std::string& more = stage) {
  try {
    parse_recipe(head + shape + more, "r.toml");
  } catch (const InputError& error) {
    const std::string what = error.what(), place = "r.toml:" + std::to_string(10 + line);
    if (error.problems().size() == 1 && what.find(place) != std::string::npos && what.find(part) != std::string::npos)
      return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << what << "\nis not at " << place;
  }
  return ::testing::AssertionFailure() << "was read";
}

TEST(ShapesInRecipes, AreReadAndWritten) {
  for (const std::string shape :
       {"shape = \"clump\"\n", "shape = \"clump\"\nmembers = 5\narrangement = \"ring\"\nspacing = 0.5\n",
        "shape = \"polygon\"\ncorners = 3\naspect = 2\nrounding = 0.2\n"}) {
    const Recipe recipe = parse_recipe(head + shape + stage, "r.toml");
    EXPECT_TRUE(parse_recipe(to_toml(recipe), "r.toml") == recipe) << shape;
    EXPECT_FALSE(std::holds_alternative<packing::DiskShape>(recipe.populations[0].shape));
  }
}

TEST(ShapesInRecipes, WithoutDisksOrCornersEnoughAreRefused) {
  EXPECT_TRUE(is_refused("shape = \"clump\"\nmembers = 0\n", 2, "members"));
  EXPECT_TRUE(is_refused("shape = \"clump\"\nmembers = 1\n", 2, "2 to 64"));
  EXPECT_TRUE(is_refused("shape = \"polygon\"\ncorners = 2\n", 2, "3 to 64"));
  EXPECT_TRUE(is_refused("shape = \"polygon\"\ncorners = 4.5\n", 2, "corners"));
  EXPECT_TRUE(
      is_refused("shape = \"clump\"\nmembers = 2\narrangement = \"ring\"\n", 2, "a ring needs 3 members or more"));
}

TEST(ShapesInRecipes, ThatFallApartOrHaveNoCornersRoundedAreRefused) {
  EXPECT_TRUE(is_refused("shape = \"clump\"\nmembers = 3\naspect = 4\n", 3, "must not be above members"));
  EXPECT_TRUE(is_refused("shape = \"clump\"\naspect = 0.5\n", 2, "aspect"));
  EXPECT_TRUE(is_refused("shape = \"clump\"\nmembers = 4\narrangement = \"ring\"\nspacing = 1.1\n", 4, "spacing"));
  EXPECT_TRUE(is_refused("shape = \"polygon\"\nrounding = 0\n", 2, "from 0.01 to 0.5"));
}

TEST(ShapesInRecipes, OfOtherWordsAreRefusedByTheWordsThereAre) {
  EXPECT_TRUE(is_refused("shape = \"polygons\"\n", 1, "polygon"));
  EXPECT_TRUE(is_refused("shape = \"disk\"\ncorners = 4\n", 2, "corners"));
  EXPECT_TRUE(is_refused("shape = \"clump\"\nrounding = 0.1\n", 2, "rounding"));
}

TEST(ShapesInRecipes, GrainsInSpaceAreSpheresAndWereOnceCalledDisks) {
  const auto in_space = [](const std::string& shape) {
    const auto& templates = recipe_templates();
    const auto spheres = std::ranges::find(templates, std::string_view("spheres"), &RecipeTemplate::name);
    std::string text = to_toml(spheres->make());
    const std::string own = "shape = \"sphere\"\n";
    const auto at = text.find(own);
    EXPECT_NE(at, std::string::npos) << text;
    return parse_recipe(text.replace(at, own.size(), shape), {});
  };
  const Recipe now = in_space("shape = \"sphere\"\n");
  for (const char* shape : {"", "shape = \"disk\"\n"}) {
    const Recipe then = in_space(shape);
    EXPECT_EQ(to_toml(then), to_toml(now)) << shape;
    EXPECT_EQ(then.notices, now.notices) << shape;
  }
  EXPECT_EQ(changed_keys(now).find("shape"), std::string::npos) << "results keep their names";
  EXPECT_THROW(in_space("shape = \"clump\"\n"), InputError);
  EXPECT_TRUE(is_refused("shape = \"sphere\"\n", 1, "sphere"));
}

TEST(ShapesInRecipes, AreRefusedWhereOnlyDisksCanBe) {
  const int population = -3;  // the line of [[populations]]
  const std::string bonds =
      "[contact]\nbonds = \"parallel\"\nbond_modulus = \"1 GPa\"\nbond_tensile_strength = \"1 MPa\"\nbond_cohesion = "
      "\"1 MPa\"\n";
  EXPECT_TRUE(is_refused("shape = \"polygon\"\n", population, "integration.integrator",
                         "[integration]\nintegrator = \"gear5\"\n" + stage));
  EXPECT_TRUE(is_refused("shape = \"clump\"\n", population, "bonds join disks only", bonds + stage));
  EXPECT_TRUE(is_refused("shape = \"clump\"\n", population, "rough walls work with disks only",
                         stage + "rough = { top = true }\n"));
}

}  // namespace
}  // namespace arenite::recipe
