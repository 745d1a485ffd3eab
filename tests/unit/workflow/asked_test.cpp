#include "workflow/asked.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "io/results/results.hpp"
#include "support/small_study.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::workflow {
namespace {

recipe::Recipe recipe_with(const std::string& stage) {
  return recipe::parse_recipe(test::small_packing_recipe + "[[stages]]\nname = \"load\"\n" + stage, "r.toml");
}

Asked asked_with(const std::string& stage) {
  StageResult made;
  note_asked(made, recipe_with(stage), 1);
  return made.asked;
}

TEST(Asked, IsWhatTheRecipeSaysOfTheStage) {
  const Asked asked = asked_with(
      "friction = 0.15\ngravity = true\nduration = \"1 s\"\ntop = { pressure = \"1 kPa\" }\nslide = { top = \"20 "
      "mm/s\" "
      "}\n");
  EXPECT_TRUE(asked.known && asked.in_motion);
  EXPECT_EQ(asked.friction, 0.15);
  EXPECT_EQ(asked.gravity.y, -9.81);
  EXPECT_EQ(asked.slide[top], 0.02);
  EXPECT_EQ(asked.load_axis, 0.75 * std::numbers::pi);
  EXPECT_EQ(asked.cycled, -1);
  EXPECT_EQ(asked_with("strain_cycles = { of = \"top\", min = 0, max = 0.01, rate = \"1 1/s\", count = 2 }\n").cycled,
            top);
}

TEST(Asked, GravityIsThatOfItsProgrammeAtTheEnd) {
  EXPECT_EQ(asked_with("gravity = true\ngravity_size = \"1.62 m/s^2\"\n").gravity.y, -1.62);
  const std::string growing =
      "programmes = [{ of = \"gravity_size\", table = [[\"0 s\", \"2 m/s^2\"], [\"1 s\", \"6 m/s^2\"]] }]\n";
  EXPECT_NEAR(asked_with("gravity = true\nduration = \"500 ms\"\n" + growing).gravity.y, -4, 1e-12);
  EXPECT_EQ(norm(asked_with("").gravity), 0);
}

TEST(Asked, ThePackingHasTheSizeCurveOfItsLaws) {
  StageResult packed;
  note_asked(packed, recipe_with(""), 0);
  ASSERT_GE(packed.asked.diameter.size(), 3u);
  EXPECT_NEAR(packed.asked.passing.back(), 1, 1e-12);
}

StageResult made_of(const recipe::Recipe& recipe) {
  StageResult made;
  made.name = made.provenance.stage = "load";
  made.provenance.recipe = to_toml(recipe);
  made.history.columns = {{"time", "s", {0.5, 1}}};
  made.snapshots.emplace_back();
  return made;
}

TEST(Asked, IsStoredAndReadBackAndNeverTakenFromAProvenance) {
  const test::TemporaryFolder folder;
  const auto recipe =
      recipe_with("duration = \"1 s\"\nslide = { top = \"20 mm/s\" }\ntop = { pressure = \"1 kPa\" }\n");
  StageResult noted = made_of(recipe);
  note_asked(noted, recipe, 1);
  noted.asked.friction = 0.123;  // as nothing but the file has it
  io::write_stage(folder / "noted.h5", noted);
  const StageResult read = io::read_stage(folder / "noted.h5");
  EXPECT_EQ(read.asked.friction, 0.123);
  EXPECT_EQ(read.asked.slide, noted.asked.slide);
  EXPECT_EQ(read.asked.load_axis, noted.asked.load_axis);
  EXPECT_EQ(*read.history.find("top_slid"), (std::vector<double>{0.01, 0.02}));

  io::write_stage(folder / "unnoted.h5", made_of(recipe));
  EXPECT_FALSE(io::read_stage(folder / "unnoted.h5").asked.known);
}

}  // namespace
}  // namespace arenite::workflow
