#include <gtest/gtest.h>

#include "workflow/film/film_grains.hpp"

namespace arenite::workflow {
namespace {

recipe::FilmRecipe framed() {
  recipe::FilmRecipe recipe;
  recipe.materials = {{"POM", 0.015e-6, 0.1, 0.9}, {"HDPE", 0.0258e-6, 0.9, 0.9}};
  recipe.container = {.width = 0.100, .height = 0.060, .thickness = 0.05, .left = {}, .top = {}, .travel = 0.004};
  recipe.picture.pixel = 0.002;
  return recipe;
}

TEST(FilmPlace, FrameIsInTheMiddleUnlessItIsGiven) {
  FilmInfo film;
  film.width = 71;   // centre of the picture: column 35
  film.height = 41;  // row 20
  recipe::FilmRecipe recipe = framed();
  const FilmPlace place = place_of(recipe, film);
  EXPECT_NEAR(place.metres({35, 20}).x, 0.050, 1e-15);
  EXPECT_NEAR(place.metres({35, 20}).y, 0.030, 1e-15);
  // Down in the picture is down in the frame: its lower left corner is 25 columns left of the middle and 15 rows below
  // it.
  EXPECT_NEAR(place.metres({10, 35}).x, 0, 1e-15);
  EXPECT_NEAR(place.metres({10, 35}).y, 0, 1e-15);
  recipe.container.left = 3;
  recipe.container.top = 4;
  const FilmPlace given = place_of(recipe, film);
  EXPECT_NEAR(given.metres({3, 4}).x, 0, 1e-15);
  EXPECT_NEAR(given.metres({3, 4}).y, 0.060, 1e-15);
}

TEST(FilmPlace, MetresAndPixelsAreEachOthersInverse) {
  FilmInfo film;
  film.width = 320;
  film.height = 240;
  const FilmPlace place = place_of(framed(), film);
  const Vec2 at = place.metres({17.25, 203.5});
  EXPECT_NEAR(place.pixels(at).x, 17.25, 1e-11);
  EXPECT_NEAR(place.pixels(at).y, 203.5, 1e-11);
}

TEST(FilmPlace, LowerWallTravelsWithTheLoad) {
  EXPECT_EQ(container_at(framed(), 0).height(), 0.060);
  EXPECT_DOUBLE_EQ(container_at(framed(), 1).height(), 0.056);
  EXPECT_DOUBLE_EQ(container_at(framed(), 0.5).wall[bottom].position, 0.002);
  EXPECT_EQ(container_at(framed(), 1).width(), 0.100);
  EXPECT_EQ(container_at(framed(), 1).thickness, 0.05);
}

TEST(FilmPlace, GrainsKeepOrderMaterialAndSize) {
  PictureGrains found;
  found.centre = {{10, 35}, {20, 30}};
  found.radius = {4, 2.5};
  found.material = {1, 0};
  FilmInfo film;
  film.width = 71;
  film.height = 41;
  const Grains grains = in_metres(found, place_of(framed(), film));
  ASSERT_EQ(grains.size(), 2u);
  EXPECT_NEAR(grains.position[1].x, 0.020, 1e-15);
  EXPECT_NEAR(grains.position[1].y, 0.010, 1e-15);
  EXPECT_DOUBLE_EQ(grains.radius[0], 0.008);
  EXPECT_EQ(grains.material, (std::vector<std::int32_t>{1, 0}));
  EXPECT_EQ(grains.id, (std::vector<std::int64_t>{1, 2}));
  const auto materials = materials_of(framed());
  EXPECT_EQ(materials[1].name, "HDPE");
  EXPECT_EQ(materials[1].thermoelastic_factor, 0.0258e-6);
}

}  // namespace
}  // namespace arenite::workflow
