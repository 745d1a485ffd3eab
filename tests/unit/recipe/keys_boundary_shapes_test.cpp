#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "recipe/recipe.hpp"
#include "unit/recipe/glass_grains.hpp"

namespace arenite::recipe {
namespace {

Recipe with_boundary(const std::string& figure) {
  return parse_recipe(
      "[variables]\nD = \"80 mm\"\n[container]\nwidth = \"100 mm\"\nheight = \"100 mm\"\nthickness = \"10 mm\"\n" +
          testing::glass_grains + "[[boundaries]]\nname = \"drum\"\n" + figure +
          "\n[[stages]]\nname = \"turn\"\nduration = \"1 s\"\nboundaries = [{ name = \"drum\", spin = \"15 rpm\" }]\n",
      "r.toml");
}

TEST(BoundaryShapes, CircleHasItsPointsOnIt) {
  const Recipe recipe =
      with_boundary("circle = { x = \"50 mm\", y = \"D/2 + 1 cm\", diameter = \"D\", segments = 32 }");
  const Boundary& drum = recipe.boundaries.front();
  EXPECT_TRUE(drum.closed);
  ASSERT_EQ(drum.points.size(), 32u);
  for (const Vec2 p : drum.points) EXPECT_NEAR(norm(p - Vec2{0.05, 0.05}), 0.04, 1e-15);
  EXPECT_NEAR(recipe.stages[0].boundaries[0].spin, 15 * 2 * std::numbers::pi / 60, 1e-15);
  EXPECT_EQ(parse_recipe(to_toml(recipe), "r.toml"), recipe);
}

TEST(BoundaryShapes, ACircleTouchesItsBoxWithoutTheNoiseOfArithmetic) {
  const Boundary drum =
      with_boundary("circle = { x = \"105 mm\", y = \"105 mm\", diameter = \"200 mm\" }").boundaries.front();
  EXPECT_EQ(drum.points[0], (Vec2{0.205, 0.105}));
  EXPECT_EQ(drum.points[16], (Vec2{0.105, 0.205}));
  EXPECT_EQ(drum.points[32], (Vec2{0.005, 0.105}));
}

TEST(BoundaryShapes, ArcIsOpenAndEndsWhereItIsTold) {
  const Boundary arc =
      with_boundary(
          "arc = { x = \"50 mm\", y = \"50 mm\", diameter = \"60 mm\", from = \"180 deg\", to = \"360 deg\" }")
          .boundaries.front();
  EXPECT_FALSE(arc.closed);
  ASSERT_EQ(arc.points.size(), 65u);
  EXPECT_NEAR(arc.points.front().x, 0.02, 1e-15);
  EXPECT_NEAR(arc.points.back().x, 0.08, 1e-15);
  EXPECT_NEAR(arc.points[32].y, 0.02, 1e-15);
}

TEST(BoundaryShapes, RectangleAndPolygonAreClosed) {
  const Boundary box =
      with_boundary("rectangle = { left = \"1 cm\", right = \"3 cm\", bottom = \"2 cm\", top = \"5 cm\" }")
          .boundaries.front();
  EXPECT_TRUE(box.closed);
  EXPECT_EQ(box.points, (std::vector<Vec2>{{0.01, 0.02}, {0.03, 0.02}, {0.03, 0.05}, {0.01, 0.05}}));
  const Boundary hexagon =
      with_boundary("polygon = { x = \"50 mm\", y = \"50 mm\", diameter = \"20 mm\", corners = 6 }").boundaries.front();
  ASSERT_EQ(hexagon.points.size(), 6u);
  EXPECT_NEAR(norm(hexagon.points[1] - hexagon.points[0]), 0.01, 1e-15);
}

TEST(BoundaryShapes, JustOneIsGiven) {
  EXPECT_THROW(with_boundary(""), InputError);
  EXPECT_THROW(
      with_boundary("points = [[\"0 mm\", \"0 mm\"], [\"1 mm\", \"0 mm\"]]\ncircle = { x = \"50 mm\", y = \"50 mm\", "
                    "diameter = \"20 mm\" }"),
      InputError);
  EXPECT_THROW(with_boundary("rectangle = { left = \"3 cm\", right = \"1 cm\", bottom = \"2 cm\", top = \"5 cm\" }"),
               InputError);
}

}  // namespace
}  // namespace arenite::recipe
