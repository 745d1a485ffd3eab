#include <gtest/gtest.h>

#include <numbers>

#include "grains/fields/loading_axis.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "support/small_study.hpp"
#include "workflow/asked.hpp"

namespace arenite::workflow {
namespace {

texture::Options texture_options(const recipe::Recipe& recipe, std::size_t place, StageResult made) {
  note_asked(made, recipe, place);
  return fields::texture_options(made);
}

texture::Options options_with(const std::string& contact) {
  return texture_options(
      recipe::parse_recipe(test::small_packing_recipe + "[contact]\n" + contact +
                               "[[stages]]\nname = \"load\"\ngravity = true\ntop = { force = \"1 kN\" }\n",
                           "r.toml"),
      1, {});
}

TEST(TextureOptions, TellWhatMayPull) {
  EXPECT_EQ(options_with("").pull, texture::Pull::measured);
  EXPECT_EQ(options_with("attractive_dashpot = true\n").pull, texture::Pull::dashpots);
  EXPECT_EQ(options_with("attractive_dashpot = true\nadhesion = \"geometrical\"\nsurface_energy = \"1 kN/mm\"\n").pull,
            texture::Pull::adhesion);
  EXPECT_EQ(options_with("").gravity.y, -dem::standard_gravity);
}

std::optional<double> axis_with(const std::string& sides) {
  return texture_options(
             recipe::parse_recipe(test::small_packing_recipe + "[[stages]]\nname = \"load\"\n" + sides, "r.toml"), 1,
             {})
      .load_axis;
}

TEST(TextureOptions, SignsReferToTheAxisAlongWhichTheSidesLoad) {
  EXPECT_EQ(axis_with("top = { force = \"1 kN\" }\n"), std::numbers::pi / 2);
  EXPECT_EQ(axis_with("left = { pressure = \"1 kPa\" }\nright = { pressure = \"1 kPa\" }\n"), 0);
  EXPECT_FALSE(axis_with("left = { pressure = \"1 kPa\" }\ntop = { pressure = \"1 kPa\" }\n"));
  EXPECT_EQ(axis_with("right = { pressure = \"10 kPa\" }\ntop = { pressure = \"12 kPa\" }\n"), std::numbers::pi / 2);
  EXPECT_EQ(axis_with("right = { pressure = \"12 kPa\" }\ntop = { pressure = \"10 kPa\" }\n"), 0);
  EXPECT_FALSE(axis_with("left = { pressure = \"1 kPa\" }\ntop = { force = \"1 kN\" }\n"));
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
  EXPECT_EQ(axis_with(pressed + "slide = { top = \"1 mm/s\", bottom = \"1 mm/s\" }\n"), std::numbers::pi / 2)
      << "where both slide alike, what presses counts";
  dem::Stage cell;
  cell.shear_rate = 2;
  EXPECT_EQ(fields::loading_axis(cell), forth);
  cell.shear_rate = -2;
  EXPECT_EQ(fields::loading_axis(cell), back);
  cell.programmes = {{{dem::Programme::What::shear_rate}, {{0, 0}, {1, 3}}}};
  EXPECT_EQ(fields::loading_axis(cell), forth);
  dem::Stage cycled;
  cycled.strain_cycles = {dem::StrainCycles::shear, -0.1, 0.1, 1, 3, {}};
  EXPECT_EQ(fields::loading_axis(cycled), forth);
  cycled.strain_cycles->of = top;
  EXPECT_EQ(fields::loading_axis(cycled), std::numbers::pi / 2);
}

TEST(TextureOptions, WeighByTheGravityOfTheStageAtItsEnd) {
  const std::string turned =
      "[[stages]]\nname = \"load\"\ngravity = true\ngravity_size = \"4 m/s^2\"\ngravity_angle = \"30 deg\"\nduration = "
      "\"2 s\"\n";
  const auto gravity = [](const std::string& stage) {
    return texture_options(recipe::parse_recipe(test::small_packing_recipe + stage, "r.toml"), 1, {}).gravity;
  };
  EXPECT_NEAR(gravity(turned).x, 2, 1e-12);
  EXPECT_NEAR(gravity(turned).y, -4 * std::cos(std::numbers::pi / 6), 1e-12);
  const std::string grows =
      "programmes = [{ of = \"gravity_size\", table = [[\"0 s\", \"4 m/s^2\"], [\"2 s\", \"8 m/s^2\"]] }]\n";
  EXPECT_NEAR(gravity(turned + grows).x, 4, 1e-12);
}

TEST(TextureOptions, TellHowTheStressOfAStageInMotionFluctuates) {
  StageResult made;
  made.snapshots.emplace_back().packing.domain.thickness = 0.1;
  for (const char* name : {"time", "left_position", "right_position", "bottom_position", "top_position", "left_force",
                           "right_force", "bottom_force", "top_force"})
    made.history.columns.push_back({name, "", {}});
  for (int k = 0; k < 400; ++k) {
    const double pressure = 100 + (k < 200 ? 50 : 0) + 3 * std::sin(k);
    for (auto& [name, unit, values] : made.history.columns)
      values.push_back(name == "time"                                       ? k
                       : name == "right_position" || name == "top_position" ? 2
                       : name.ends_with("force")                            ? 0.2 * pressure
                                                                            : 0);
  }
  const auto in_time = [&](const std::string& stage) {
    return texture_options(
               recipe::parse_recipe(test::small_packing_recipe + "[[stages]]\nname = \"load\"\n" + stage, "r.toml"), 1,
               made)
        .in_time;
  };
  EXPECT_FALSE(in_time("top = { pressure = \"1 kPa\" }\n"));
  const auto sheared = in_time("top = { velocity = \"1 mm/s\" }\nduration = \"1 s\"\n");
  ASSERT_TRUE(sheared);
  EXPECT_NEAR(sheared->pressure, 0.03 / std::sqrt(2), 2e-4);
  EXPECT_NEAR(sheared->stress.xx, 3 / std::sqrt(2), 2e-2);
  EXPECT_EQ(sheared->stress.xy, 0);
  made.history.columns.clear();
  EXPECT_TRUE(std::isnan(in_time("top = { velocity = \"1 mm/s\" }\nduration = \"1 s\"\n")->pressure));
}

}  // namespace
}  // namespace arenite::workflow
