#include "workflow/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "grains/dem/run_stage.hpp"
#include "io/atomic_file.hpp"
#include "io/checkpoint.hpp"
#include "io/stage_file.hpp"
#include "workflow/field_stages.hpp"
#include "workflow/result_folder.hpp"
#include "workflow/stored.hpp"

namespace arenite::study {

namespace fs = std::filesystem;

namespace {

void measure_last_frame(StageResult& result, const texture::Options& options) {
  if (!result.frames.empty()) result.texture = texture::numbers(texture::measure(result.frames.back().packing, options));
}

io::Checkpoint to_checkpoint(const dem::Engine& engine, const dem::StageRun& run, const std::string& key) {
  io::Checkpoint checkpoint;
  checkpoint.key = key;
  checkpoint.blobs["engine"] = engine.save();
  for (int side = 0; side < 4; ++side) checkpoint.numbers[fmt::format("force_at_start {}", side_names[side])] = run.force_at_start[side];
  checkpoint.integers = {{"increment", run.increment}, {"steps_in_increment", run.steps_in_increment},
                         {"sample_every", run.sample_every}, {"checks", run.checks}};
  checkpoint.partial = run.result;
  return checkpoint;
}

void restore_from(const io::Checkpoint& checkpoint, dem::Engine& engine, dem::StageRun& run) {
  engine.restore(checkpoint.blobs.at("engine"));
  for (int side = 0; side < 4; ++side) run.force_at_start[side] = checkpoint.numbers.at(fmt::format("force_at_start {}", side_names[side]));
  run.increment = checkpoint.integers.at("increment");
  run.steps_in_increment = checkpoint.integers.at("steps_in_increment");
  run.sample_every = checkpoint.integers.at("sample_every");
  run.checks = checkpoint.integers.at("checks");
  run.result = checkpoint.partial;
}

/// Runs one stage to its end, or until asked to stop (then nothing is returned, and the checkpoint is on disk).
std::optional<StageResult> load(dem::Engine& engine, const dem::Stage& stage, const std::string& key, const fs::path& checkpoint_file,
                                const RunOptions& options, Progress progress) {
  using clock = std::chrono::steady_clock;
  dem::StageRun run = dem::begin_stage(engine, stage);
  const auto checkpoint = unless_damaged(checkpoint_file, options, "the stage begins anew", [&] { return io::read_checkpoint(checkpoint_file, key); });
  if (checkpoint && *checkpoint) restore_from(**checkpoint, engine, run);
  auto saved = clock::now();
  while (!run.finished) {
    dem::continue_stage(engine, stage, run);
    progress.share = dem::share_done(stage, run);
    progress.unbalanced_ratio = run.latest.unbalanced_ratio;
    progress.step = engine.step();
    options.progress(progress);
    const bool stop = options.asked_to_stop();
    if (!run.finished && (stop || std::chrono::duration<double>(clock::now() - saved).count() >= options.checkpoint_seconds)) {
      io::write_checkpoint(checkpoint_file, to_checkpoint(engine, run, key));
      saved = clock::now();
      if (stop) return std::nullopt;
    }
  }
  run.result.continuation = engine.save();
  return std::move(run.result);
}

std::optional<StageResult> packing_stage(const Recipe& recipe, const fs::path& file, const PlannedStage& stage, const RunOptions& options,
                                         Progress progress) {
  Claim claim(options, stage);
  auto stored = stored_or_claimed(file, options, stage, claim, io::read_stage);
  if (claim.stopped) return std::nullopt;
  progress.reused = stored.has_value();
  if (!stored) {
    auto result = make_packing(recipe);
    measure_last_frame(result, texture_options(recipe, 0));
    result.provenance = provenance_of(recipe, 0, stage, "");
    io::write_stage(file, result);
    claim.computed(file);
    stored = io::read_stage(file);
  }
  progress.share = 1;
  options.progress(progress);
  return stored;
}

/// Along which a stage loads, rad; nothing where it loads along both axes or none.
std::optional<double> loading_axis(const dem::Stage& stage) {
  const auto works = [&](std::size_t side) { return stage.side[side].kind != dem::SideDrive::Kind::fixed; };
  const bool across = works(left) || works(right), along = works(bottom) || works(top);
  if (across == along) return std::nullopt;
  return along ? std::numbers::pi / 2 : 0;
}

}  // namespace

texture::Options texture_options(const Recipe& recipe, std::size_t stage) {
  texture::Options options;
  if (recipe.contact.adhesion != dem::Adhesion::none) options.pull = texture::Pull::adhesion;
  else if (recipe.contact.attractive_dashpot) options.pull = texture::Pull::dashpots;
  if (stage == 0) return options;
  if (recipe.stages[stage - 1].gravity) options.gravity = {0, -dem::standard_gravity};
  options.load_axis = loading_axis(recipe.stages[stage - 1]);
  return options;
}

texture::Options texture_options(const Provenance& provenance) {
  Recipe recipe;
  try {
    recipe = parse_recipe(provenance.recipe, "recipe");
  } catch (const InputError&) {
    return {};
  }
  const auto at = std::find_if(recipe.stages.begin(), recipe.stages.end(), [&](const auto& stage) { return stage.name == provenance.stage; });
  return texture_options(recipe, at == recipe.stages.end() ? 0 : static_cast<std::size_t>(at - recipe.stages.begin()) + 1);
}

namespace {

/// All stages of loading by discrete elements; true if the run may go on.
bool run_stages(const Recipe& recipe, const std::vector<PlannedStage>& plan, const ResultFolder& folder, const RunOptions& options,
                Progress& progress, RunOutcome& outcome) {
  const Packing start = outcome.stages[0].frames.back().packing;
  std::optional<dem::Engine> engine;
  for (std::size_t s = 0; s < recipe.stages.size(); ++s) {
    const PlannedStage& stage = plan[s + 1];
    const fs::path file = folder / stage.file;
    progress.stage = s + 1;
    progress.name = stage.name;
    Claim claim(options, stage);
    auto result = stored_or_claimed(file, options, stage, claim, io::read_stage);
    progress.reused = result.has_value();
    if (!result && !claim.stopped) {
      if (!engine) engine.emplace(start, recipe.contact, recipe.integration);
      if (s > 0) engine->restore(outcome.stages.back().continuation);
      result = load(*engine, recipe.stages[s], stage.hash, claim.checkpoint(folder / "run.checkpoint"), options, progress);
      if (result) {
        measure_last_frame(*result, texture_options(recipe, s + 1));
        result->provenance = provenance_of(recipe, s + 1, stage, engine->kernel());
        io::write_stage(file, *result);
        claim.computed(file);
      } else {
        claim.interrupted();
      }
    }
    if (!result) {
      outcome.interrupted = true;
      return false;
    }
    if (progress.reused) {
      progress.share = 1;
      options.progress(progress);
    }
    outcome.stages.push_back(std::move(*result));
    outcome.files.push_back(file);
    outcome.converged = outcome.stages.back().converged;
    if (!outcome.converged) return false;
  }
  return true;
}

RunOutcome run_in_folder(const Recipe& recipe, const RunOptions& options) {
  const std::vector<PlannedStage> plan = plan_of(recipe);
  std::vector<std::string> names, former;
  for (const PlannedStage& stage : plan) {
    names.push_back(stage.file);
    former.push_back(stage.former);
  }
  Progress progress{0, plan.size(), "packing", 0, 0, 0, false, false};
  const ResultFolder folder(options.out, names, former);
  if (const std::string sentence = folder.what_was_put_aside(); !sentence.empty()) options.notice(sentence);

  RunOutcome outcome;
  auto packing = packing_stage(recipe, folder / names[0], plan[0], options, progress);
  outcome.interrupted = !packing;
  if (!packing) return outcome;
  outcome.files.push_back(folder / names[0]);
  outcome.stages.push_back(std::move(*packing));
  io::write_atomically(folder / "recipe.toml", to_toml(recipe));
  if (run_stages(recipe, plan, folder, options, progress, outcome) && recipe.has_field()) run_fields(recipe, plan, folder, options, progress, outcome);
  if (outcome.interrupted) return outcome;
  // At the very end, since a run may be killed between writing its last file and this.
  std::error_code error;
  fs::remove(folder / "run.checkpoint", error);
  return outcome;
}

}  // namespace

RunOutcome run(const Recipe& recipe, const RunOptions& options) {
  const bool was_there = fs::exists(options.out);
  try {
    dem::kernel_name(recipe.integration.kernel);
    return run_in_folder(recipe, options);
  } catch (const InputError& error) {
    std::error_code ignored;
    if (!was_there) fs::remove(options.out, ignored);  // only if nothing is in it
    throw in_file(error, recipe.source_file);
  }
}

}  // namespace arenite::study
