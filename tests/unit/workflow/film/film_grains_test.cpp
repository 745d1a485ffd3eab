#include <gtest/gtest.h>

#include "support/drawn_picture.hpp"
#include "workflow/film/film_grains.hpp"

namespace arenite::workflow {
namespace {

/// Eight by eight grains of 6 pixels' radius, `apart` pixels from centre to centre, fill a frame of 1 mm pixels.
std::vector<std::string> notes_on_grains(double apart) {
  std::vector<test::DrawnDisk> disks;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column)
      disks.push_back({10 + apart * (column + 0.5), 10 + apart * (row + 0.5), 6});
  const int side = static_cast<int>(8 * apart) + 20;
  const FloatImage image = test::draw(disks, {.width = side, .height = side, .noise = 0.01});
  recipe::FilmRecipe recipe;
  recipe.materials = {{"POM", 0.015e-6}};
  recipe.picture.pixel = 1e-3;
  recipe.container.width = recipe.container.height = 8 * apart * 1e-3;
  FilmInfo film;
  film.width = film.height = side;
  std::vector<std::string> notes;
  EXPECT_EQ(find_film_grains(recipe, place_of(recipe, film), film, image.value, {}, notes).size(), 64u);
  return notes;
}

TEST(FindGrains, WarnsOfGrainsThatCoverLittleOfTheFrame) {
  // Squares of 12.5 pixels hold pi 36/12.5^2 = 72 %, those of 14 hold 58 %.
  EXPECT_TRUE(notes_on_grains(12.5).empty());
  const auto notes = notes_on_grains(14);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("the 64 grains that were found cover 58 % of the container"), std::string::npos) << notes[0];
  EXPECT_NE(notes[0].find("picture.optical"), std::string::npos);
}

}  // namespace
}  // namespace arenite::workflow
