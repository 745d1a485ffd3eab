#include <gtest/gtest.h>

#include <numbers>

#include "support/small_study.hpp"
#include "workflow/run.hpp"

namespace arenite::workflow {
namespace {

texture::Options options_with(const std::string& contact) {
  return texture_options(
      recipe::parse_recipe(test::small_packing_recipe + "[contact]\n" + contact + "[[stages]]\nname = \"load\"\ngravity = true\ntop = { force = \"1 kN\" }\n",
                           "r.toml"),
      1);
}

TEST(TextureOptions, TellWhatMayPull) {
  EXPECT_EQ(options_with("").pull, texture::Pull::measured);
  EXPECT_EQ(options_with("attractive_dashpot = true\n").pull, texture::Pull::dashpots);
  EXPECT_EQ(options_with("attractive_dashpot = true\nadhesion = \"geometrical\"\nsurface_energy = \"1 kN/mm\"\n").pull, texture::Pull::adhesion);
  EXPECT_EQ(options_with("").gravity.y, -dem::standard_gravity);
}

std::optional<double> axis_with(const std::string& sides) {
  return texture_options(recipe::parse_recipe(test::small_packing_recipe + "[[stages]]\nname = \"load\"\n" + sides, "r.toml"), 1).load_axis;
}

TEST(TextureOptions, SignsReferToTheAxisAlongWhichTheSidesLoad) {
  EXPECT_EQ(axis_with("top = { force = \"1 kN\" }\n"), std::numbers::pi / 2);
  EXPECT_EQ(axis_with("left = { pressure = \"1 kPa\" }\nright = { pressure = \"1 kPa\" }\n"), 0);
  EXPECT_FALSE(axis_with("left = { pressure = \"1 kPa\" }\ntop = { pressure = \"1 kPa\" }\n"));
  EXPECT_FALSE(axis_with("gravity = true\n"));
}

}  // namespace
}  // namespace arenite::workflow
