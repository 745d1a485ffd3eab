#include <gtest/gtest.h>

#include <filesystem>

#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "support/small_study.hpp"
#include "support/temporary_folder.hpp"
#include "workflow/run.hpp"
#include "workflow/stage_keys.hpp"

namespace arenite::workflow {
namespace {

namespace fs = std::filesystem;

struct Counted {
  std::size_t made = 0, reused = 0;
};

Counted run_in(const fs::path& out, const recipe::Recipe& recipe) {
  Counted counted;
  RunOptions options;
  options.out = out;
  options.progress = [&](const Progress& p) {
    if (p.share == 1) ++(p.reused ? counted.reused : counted.made);
  };
  EXPECT_TRUE(run(recipe, options).converged);
  return counted;
}

/// Makes a run's files those that version 0.1 would have left.
void make_former(const fs::path& out, const std::vector<PlannedStage>& plan) {
  for (const PlannedStage& stage : plan) {
    const auto to_former = [&](auto result, const auto& write) {
      result.provenance.input_hash = stage.former_hash;
      write(out / io::stage_file_name(static_cast<int>(&stage - plan.data()) + 1, stage.name, stage.former_hash), result);
    };
    if (stage.field) to_former(io::read_field(out / stage.file), io::write_field);
    else to_former(io::read_stage(out / stage.file), io::write_stage);
    fs::remove(out / stage.file);
  }
}

TEST(Run, TakesWhatVersion01LeftInItsFolder) {
  const test::TemporaryFolder folder;
  const auto recipe = recipe::parse_recipe(test::small_cemented_recipe, "recipe.toml");
  const auto plan = plan_of(recipe);
  EXPECT_EQ(run_in(folder / "out", recipe).reused, 0u);
  make_former(folder / "out", plan);
  const Counted again = run_in(folder / "out", recipe);
  EXPECT_EQ(again.reused, plan.size());
  EXPECT_EQ(again.made, 0u);
  for (const PlannedStage& stage : plan) EXPECT_TRUE(fs::exists(folder / "out" / stage.file)) << stage.file;
  EXPECT_FALSE(fs::exists(folder / "out/earlier"));
}

}  // namespace
}  // namespace arenite::workflow
