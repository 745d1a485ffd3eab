#include <gtest/gtest.h>

#include <numbers>

#include "grains/fields/loading_axis.hpp"
#include "support/small_study.hpp"
#include "workflow/run.hpp"

namespace arenite::workflow {
namespace {

texture::Options options_with(const std::string& contact) {
  return texture_options(
      recipe::parse_recipe(test::small_packing_recipe + "[contact]\n" + contact + "[[stages]]\nname = \"load\"\ngravity = true\ntop = { force = \"1 kN\" }\n",
                           "r.toml"),
      1, {});
}

TEST(TextureOptions, TellWhatMayPull) {
  EXPECT_EQ(options_with("").pull, texture::Pull::measured);
  EXPECT_EQ(options_with("attractive_dashpot = true\n").pull, texture::Pull::dashpots);
  EXPECT_EQ(options_with("attractive_dashpot = true\nadhesion = \"geometrical\"\nsurface_energy = \"1 kN/mm\"\n").pull, texture::Pull::adhesion);
  EXPECT_EQ(options_with("").gravity.y, -dem::standard_gravity);
}

std::optional<double> axis_with(const std::string& sides) {
  return texture_options(recipe::parse_recipe(test::small_packing_recipe + "[[stages]]\nname = \"load\"\n" + sides, "r.toml"), 1, {}).load_axis;
}

TEST(TextureOptions, SignsReferToTheAxisAlongWhichTheSidesLoad) {
  EXPECT_EQ(axis_with("top = { force = \"1 kN\" }\n"), std::numbers::pi / 2);
  EXPECT_EQ(axis_with("left = { pressure = \"1 kPa\" }\nright = { pressure = \"1 kPa\" }\n"), 0);
  EXPECT_FALSE(axis_with("left = { pressure = \"1 kPa\" }\ntop = { pressure = \"1 kPa\" }\n"));
  EXPECT_FALSE(axis_with("gravity = true\n"));
}

TEST(TextureOptions, SignsReferToTheAxisThatAWallMovesInAlongWhateverPressesAcrossIt) {
  const std::string across = "duration = \"1 s\"\nright = { pressure = \"1 kPa\" }\n";
  EXPECT_EQ(axis_with(across + "top = { velocity = \"1 mm/s\" }\n"), std::numbers::pi / 2);
  EXPECT_EQ(axis_with(across + "top = { velocity = \"-1 mm/s\" }\n"), 0) << "drawn apart along y";
}

TEST(TextureOptions, SignsReferToTheDiagonalThatShearCompresses) {
  const double forth = 3 * std::numbers::pi / 4, back = std::numbers::pi / 4;
  const std::string time = "duration = \"1 s\"\n", pressed = time + "top = { pressure = \"1 kPa\" }\n";
  EXPECT_EQ(axis_with(pressed + "slide = { top = \"1 mm/s\" }\n"), forth);
  EXPECT_EQ(axis_with(pressed + "slide = { bottom = \"1 mm/s\" }\n"), back);
  EXPECT_EQ(axis_with(time + "slide = { right = \"1 mm/s\" }\n"), forth);
  EXPECT_EQ(axis_with(pressed + "slide = { top = \"1 mm/s\", bottom = \"1 mm/s\" }\n"), std::numbers::pi / 2) << "where both slide alike, what presses counts";
  dem::Stage cell;
  cell.shear_rate = 2;
  EXPECT_EQ(fields::loading_axis(cell), forth);
  cell.shear_rate = -2;
  EXPECT_EQ(fields::loading_axis(cell), back);
  cell.programmes = {{dem::Programme::shear_rate, {{0, 0}, {1, 3}}}};
  EXPECT_EQ(fields::loading_axis(cell), forth);
  dem::Stage cycled;
  cycled.strain_cycles = {dem::StrainCycles::shear, -0.1, 0.1, 1, 3, {}};
  EXPECT_EQ(fields::loading_axis(cycled), forth);
  cycled.strain_cycles->of = top;
  EXPECT_EQ(fields::loading_axis(cycled), std::numbers::pi / 2);
}

}  // namespace
}  // namespace arenite::workflow
