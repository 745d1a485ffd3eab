#include "campaign/study_kind.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "recipe/film_recipe.hpp"
#include "support/small_study.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::campaign {
namespace {

/// A study of so many runs whose last stage is this; their friction is 0, 0.1, 0.2, ...
StudyKind kind_with(const std::string& stage, int runs = 3) {
  const test::TemporaryFolder folder;
  for (int k = 0; k < runs; ++k) {
    const auto run = folder / "runs" / std::to_string(k);
    std::filesystem::create_directories(run);
    io::write_atomically(run / "recipe.toml", test::small_packing_recipe + "[contact]\nfriction = 0." +
                                                  std::to_string(k) + "\n[[stages]]\nname = \"test\"\n" + stage);
  }
  return kind_of_study(folder / "");
}

const std::string lasts = "duration = \"1 s\"\n", weighs = lasts + "gravity = true\n";

TEST(StudyKind, IsThatOfTheLastStages) {
  EXPECT_EQ(kind_with(weighs + "count_below = \"1 mm\"\n").flow, "beverloo");
  EXPECT_EQ(kind_with(weighs + "open = { right = true }\n").flow, "runout");
  EXPECT_EQ(kind_with(weighs + "bottom = { velocity = \"-5 mm/s\" }\n").flow, "janssen");
  EXPECT_EQ(kind_with(lasts).flow, "");
  EXPECT_EQ(kind_with(weighs + "count_below = \"1 mm\"\n", 2).flow, "") << "two points show no law";
}

TEST(StudyKind, RunsAreDrivenWhereAllStrainAtARate) {
  EXPECT_EQ(kind_with(lasts + "top = { velocity = \"75 mm/s\" }\n").driven.size(), 3u);
  EXPECT_EQ(kind_with(lasts + "slide = { top = \"1 mm/s\" }\n").driven.size(), 3u);
  EXPECT_EQ(
      kind_with(lasts + "[[stages.programmes]]\nof = \"slide.top\"\ntable = [[\"0 s\", \"1 mm/s\"]]\n").driven.size(),
      3u);
  EXPECT_TRUE(kind_with(lasts + "top = { velocity = \"75 mm/s\" }\n", 1).driven.empty());
  EXPECT_TRUE(kind_with("top = { force = \"1 kN\" }\n").driven.empty());
}

TEST(StudyKind, IsNoneWhereThereAreNoRuns) { EXPECT_TRUE(kind_of_study("/nowhere").flow.empty()); }

TEST(StudyKind, ARecipeThatCannotBeReadSaysWhy) {
  try {
    kind_with("unheard = \"of\"\n");
    ADD_FAILURE() << "an unknown key was read";
  } catch (const InputError& error) {
    EXPECT_TRUE(error.problems().front().file.ends_with("runs/0/recipe.toml")) << error.problems().front().file;
    EXPECT_NE(error.problems().front().message.find("unheard"), std::string::npos);
  }
}

TEST(StudyKind, IsNoneOfFilms) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "runs/0");
  io::write_atomically(folder / "runs/0/recipe.toml", recipe::to_toml(recipe::film_template()));
  EXPECT_TRUE(kind_of_study(folder / "").figures().empty());
}

}  // namespace
}  // namespace arenite::campaign
