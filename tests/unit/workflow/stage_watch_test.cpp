#include "workflow/stage_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "grains/dem/engine.hpp"
#include "grains/fields/regime/prediction.hpp"
#include "support/small_study.hpp"
#include "support/temporary_folder.hpp"
#include "workflow/make_packing.hpp"

namespace arenite {
namespace {

recipe::Recipe with_stage(const std::string& contact, const std::string& stage) {
  return recipe::parse_recipe(
      test::small_packing_recipe + "[contact]\n" + contact + "\n[[stages]]\nname = \"load\"\n" + stage, "recipe.toml");
}

/// The top goes down by 1 m/s until the height is shorter by a fiftieth: after a tenth of the time that it has at most.
recipe::Recipe strained(int threads = 1) {
  recipe::Recipe recipe =
      with_stage("restitution = 0.3\nfriction = 0.3",
                 "right = { pressure = \"20 kPa\" }\ntop = { velocity = \"100 mm/s\" }\nduration = \"200 ms\"\n"
                 "snapshots = 4\nuntil = \"strain_y > 2 % or q < 0.01*max(q) and time > 1 s\"\n");
  recipe.integration.threads = threads;
  return recipe;
}

struct Loaded {
  std::optional<StageResult> result;
  std::vector<std::string> notices;
  std::vector<workflow::Progress> told;
};

Loaded load(const recipe::Recipe& recipe, workflow::RunOptions options = {}, const std::filesystem::path& kept = {},
            const workflow::StepFunction* on_step = nullptr) {
  const Packing packing = workflow::make_packing(recipe).snapshots.back().packing;
  dem::Engine engine(packing, recipe.contact, recipe.integration);
  Loaded loaded;
  options.notice = [&](const std::string& sentence) { loaded.notices.push_back(sentence); };
  options.progress = [&](const workflow::Progress& progress) { loaded.told.push_back(progress); };
  loaded.result = workflow::load_stage({recipe, 1, "key", &packing}, engine, kept, options, {}, on_step);
  return loaded;
}

TEST(StageWatch, EndsWhereItsConditionHolds) {
  const StageResult result = *load(strained()).result;
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.outcome.find("strain_y > 2 % (strain_y = 0.02"), 0u) << result.outcome;
  const auto &time = *result.history.find("time"), &top_at = *result.history.find("top_position");
  const auto strain = [&](std::size_t k) { return 1 - top_at[k] / top_at.front(); };
  EXPECT_GT(strain(time.size() - 1), 0.02);
  EXPECT_LE(strain(time.size() - 2), 0.02);
  EXPECT_EQ(result.snapshots.back().time, time.back());
  EXPECT_LT(time.back(), 0.2);
  ASSERT_TRUE(result.began);
  EXPECT_EQ(*result.began, 0);
}

TEST(StageWatch, SaysWhichConditionItsDurationWasTooShortFor) {
  recipe::Recipe recipe = strained();
  recipe.stages[0].duration = 2e-3;
  const StageResult result = *load(recipe).result;
  EXPECT_NE(result.outcome.find("0.002 s passed before strain_y > 2 %"), std::string::npos) << result.outcome;
  EXPECT_FALSE(result.began);
}

TEST(StageWatch, EndsAtTheSameBitsWhateverTheThreadsAndTheStops) {
  const StageResult whole = *load(strained()).result;
  EXPECT_EQ(load(strained(2)).result->continuation, whole.continuation);
  const test::TemporaryFolder folder;
  const auto kept = folder / "kept";
  int looks = 0, lives = 0;
  workflow::RunOptions stopping;
  stopping.asked_to_stop = [&] { return ++looks % 7 == 0; };
  std::optional<StageResult> cut;
  for (; !cut && lives < 10'000; ++lives) cut = load(strained(), stopping, kept).result;
  ASSERT_TRUE(cut);
  EXPECT_GT(lives, 2);
  EXPECT_EQ(cut->continuation, whole.continuation);
  EXPECT_EQ(cut->outcome, whole.outcome);
  EXPECT_EQ(*cut->history.find("time"), *whole.history.find("time"));
  EXPECT_EQ(cut->began, whole.began);
}

/// Disks that fall to and fro between walls that stand, and lose nothing, never come to rest.
recipe::Recipe restless() {
  return with_stage("restitution = 1\nfriction = 0",
                    "gravity = true\ngravity_size = \"1000 m/s^2\"\n"
                    "equilibrium = { unbalanced = 0.1, max_steps = 150000 }\n");
}

TEST(StageWatch, SaysOnceThatItDoesNotSettleAndWhatMendsIt) {
  const recipe::Recipe recipe = restless();
  const Loaded loaded = load(recipe);
  const Packing packing = workflow::make_packing(recipe).snapshots.back().packing;
  dem::Engine engine(packing, recipe.contact, recipe.integration);
  dem::begin_stage(engine, recipe.stages[0]);
  fields::Bulk bulk = fields::bulk_of(packing, recipe.contact);
  fields::Pressures none;
  const auto predicted = fields::predict_stage(engine, recipe.contact, 0, recipe.stages[0], bulk, none);
  ASSERT_FALSE(loaded.result->converged) << loaded.result->outcome;
  ASSERT_LT(10 * predicted.increment_steps, 150'000) << "else nothing is to be told";
  ASSERT_EQ(loaded.notices.size(), 1u);
  for (const char* part : {"stage load", "unbalanced force ratio", "critical_drag", "equilibrium.unbalanced"})
    EXPECT_NE(loaded.notices[0].find(part), std::string::npos) << loaded.notices[0];
  for (const workflow::Progress& progress : loaded.told) {
    const bool late = progress.step > 10 * predicted.increment_steps + 200;
    if (progress.step == loaded.told.back().step) continue;  // the end
    EXPECT_EQ(progress.settles, progress.step < 10 * predicted.increment_steps) << progress.step;
    if (late) { EXPECT_EQ(progress.share, 0) << progress.step; }
  }
}

TEST(StageWatch, OfWhatSettlesSaysNothing) {
  const Loaded loaded = load(with_stage("restitution = 0.3\nfriction = 0.3", "top = { pressure = \"20 kPa\" }\n"));
  EXPECT_TRUE(loaded.result->converged);
  EXPECT_TRUE(loaded.notices.empty()) << loaded.notices[0];
}

TEST(StepFunction, ThatDoesNothingLeavesTheBits) {
  const StageResult whole = *load(strained()).result;
  std::vector<std::int64_t> steps;
  const workflow::StepFunction looking{[&](workflow::StageUnderWay& now) { steps.push_back(now.engine().step); }, 500};
  const StageResult seen = *load(strained(), {}, {}, &looking).result;
  EXPECT_EQ(seen.continuation, whole.continuation);
  EXPECT_EQ(seen.provenance.input_hash, whole.provenance.input_hash);
  ASSERT_GT(steps.size(), 2u);
  EXPECT_EQ(steps[0], 600);  // looks come every 200 steps
  EXPECT_EQ(steps[1], 1000);
}

TEST(StepFunction, ChangesStoresAndStops) {
  const workflow::StepFunction acting{[](workflow::StageUnderWay& now) {
                                        if (now.engine().step == 1000) {
                                          now.change({"right.pressure=40 kPa", "gravity=true"});
                                          now.store("loaded anew");
                                        }
                                        if (now.engine().step == 2000) now.stop("enough");
                                      },
                                      1000};
  const Loaded loaded = load(strained(), {}, {}, &acting);
  const StageResult& result = *loaded.result;
  EXPECT_EQ(result.outcome.find("enough"), 0u) << result.outcome;
  EXPECT_EQ(result.snapshots.back().step, 2000);
  EXPECT_EQ(result.snapshots.front().label, "loaded anew");
  EXPECT_LT(result.asked.gravity.y, -9);
  EXPECT_NE(result.provenance.input_hash, "key");
  ASSERT_EQ(result.provenance.options.size(), 4u);  // two keys, a state, the stop
  EXPECT_EQ(result.provenance.options[0].second, "right.pressure=40 kPa");
  EXPECT_NE(result.provenance.recipe.find("40 kPa"), std::string::npos);
}

TEST(StepFunction, CannotChangeWhatARecipeMayNotSayNorOtherKeys) {
  for (const char* change : {"right.pressure=40 mm", "duration=1 s", "nonsense=1", "name=other"}) {
    const workflow::StepFunction wrong{[&](workflow::StageUnderWay& now) { now.change({change}); }, 1000};
    EXPECT_THROW(load(strained(), {}, {}, &wrong), InputError) << change;
  }
}

TEST(StepFunction, AStoredStateDoesNotTakeThePlaceOfOneOfTheStages) {
  recipe::Recipe recipe = strained();
  recipe.stages[0].until.clear();
  recipe.stages[0].duration = 20e-3;
  const workflow::StepFunction storing{[](workflow::StageUnderWay& now) { now.store("extra"); }, 1000};
  const StageResult plain = *load(recipe).result, stored = *load(recipe, {}, {}, &storing).result;
  EXPECT_EQ(stored.continuation, plain.continuation);
  EXPECT_EQ(std::ranges::count(stored.snapshots, std::string("extra"), &Snapshot::label),
            static_cast<std::ptrdiff_t>(stored.snapshots.size() - plain.snapshots.size()));
  EXPECT_GT(stored.snapshots.size(), plain.snapshots.size());
}

}  // namespace
}  // namespace arenite
