#include "validation/borders.hpp"

#include <gtest/gtest.h>

#include "support/small_study.hpp"
#include "support/temporary_folder.hpp"
#include "unit/validation/made_up_table.hpp"
#include "workflow/result_folder.hpp"
#include "workflow/run.hpp"

namespace arenite::validation {
namespace {

TEST(Borders, MeasureTheSameStatesWithAnotherStripLeftOut) {
  const test::TemporaryFolder folder;
  const auto recipe =
      recipe::parse_recipe(test::small_packing_recipe +
                               "solid_fraction = 0.7\n[contact]\nfriction_law = \"cundall_strack\"\n[[stages]]\nname = "
                               "\"load\"\ntop = { force = \"100 N\" }\n",
                           "recipe.toml");
  workflow::RunOptions options;
  options.out = folder.path() / "runs" / "first";
  ASSERT_TRUE(workflow::run(recipe, options).converged);
  auto table = made_up_table({"seed"}, {"grains"}, {{{"1"}, {60}}, {{"2"}, {60}}});
  table.rows[0].run = "first";
  table.rows[1].run = "missing";
  Results results;
  results.add("made-up", table, folder.path());
  for (const double border : {0.0, 1.0})
    add_with_border(results, "made-up", border, [](const validation::Run&) { return true; });
  add_with_border(results, "made-up", 2.5, [](const validation::Run& run) { return run.text("seed") == "2"; });

  const auto without = results.runs(with_border("made-up", 0)), with = results.runs(with_border("made-up", 1));
  ASSERT_EQ(without.size(), 1u) << "the run whose files are missing is left out";
  ASSERT_EQ(with.size(), 1u);
  EXPECT_EQ(without[0].text("seed"), "1");
  EXPECT_EQ(without[0]("considered.grains"), 60);
  EXPECT_LT(with[0]("considered.grains"), 60);
  EXPECT_GT(with[0]("coordination.all"), 0);
  EXPECT_TRUE(results.runs(with_border("made-up", 2.5)).empty());
}

}  // namespace
}  // namespace arenite::validation
