#include "workflow/run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <type_traits>
#include <utility>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/version.hpp"
#include "grains/dem/kernels/kernel.hpp"
#include "grains/dem/run_stage.hpp"
#include "grains/fields/flow_numbers.hpp"
#include "io/disk/file.hpp"
#include "io/results/results.hpp"
#include "workflow/runner.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;

namespace {

/// Where a stage stands, from what it and its sample say.
void look_at(const dem::Engine& engine, const dem::Stage& stage, const dem::StageRun& run, Progress& progress) {
  progress.share = dem::share_done(stage, run);
  if (stage.duration && !run.finished)  // finer than by the states that are stored
    progress.share = std::max(progress.share, std::min(0.999, static_cast<double>(run.steps_in_increment) * engine.time_step() / *stage.duration));
  progress.increment = std::min(run.increment + 1, progress.increments);
  progress.unbalanced_ratio = run.latest.unbalanced_ratio;
  progress.step = engine.step();
  progress.time = engine.time();
  progress.wall = engine.domain().wall;
}

std::string force_at_start(int side) { return fmt::format("force_at_start {}", side_names[side]); }

constexpr std::pair<const char*, std::int64_t dem::StageRun::*> counts[] = {{"increment", &dem::StageRun::increment},
                                                                            {"steps_in_increment", &dem::StageRun::steps_in_increment},
                                                                            {"sample_every", &dem::StageRun::sample_every},
                                                                            {"checks", &dem::StageRun::checks}};

io::Checkpoint to_checkpoint(const dem::Engine& engine, const dem::StageRun& run, const std::string& key) {
  io::Checkpoint checkpoint;
  checkpoint.key = key;
  checkpoint.blobs["engine"] = engine.save();
  for (int side = 0; side < sides; ++side) checkpoint.numbers[force_at_start(side)] = run.start.force[side];
  for (const auto& [name, count] : counts) checkpoint.integers[name] = run.*count;
  checkpoint.partial = run.result;
  return checkpoint;
}

void restore_from(const io::Checkpoint& checkpoint, dem::Engine& engine, dem::StageRun& run) {
  engine.restore(checkpoint.blobs.at("engine"));
  for (int side = 0; side < sides; ++side) run.start.force[side] = checkpoint.numbers.at(force_at_start(side));
  for (const auto& [name, count] : counts) run.*count = checkpoint.integers.at(name);
  run.result = checkpoint.partial;
}

/// Runs one stage to its end, or until asked to stop (then nothing is returned, and the checkpoint is on disk).
std::optional<StageResult> load(dem::Engine& engine, const dem::Stage& stage, const std::string& key, const fs::path& checkpoint_file,
                                const RunOptions& options, Progress progress) {
  dem::StageRun run = dem::begin_stage(engine, stage);
  const auto checkpoint = unless_damaged(checkpoint_file, options, "the stage begins anew", [&] { return io::read_checkpoint(checkpoint_file, key); });
  if (checkpoint && *checkpoint) restore_from(**checkpoint, engine, run);
  progress.increments = stage.duration ? 0 : dem::increment_count(stage);
  CheckpointTimes times(options);
  while (!run.finished) {
    dem::continue_stage(engine, stage, run);
    look_at(engine, stage, run, progress);
    options.progress(progress);
    if (run.finished || !times.is_due()) continue;
    io::write_checkpoint(checkpoint_file, to_checkpoint(engine, run, key));
    if (times.asked_to_stop()) return std::nullopt;
  }
  run.result.continuation = engine.save();
  return std::move(run.result);
}

/// A run on its way through its plan.
class Run {
 public:
  Run(const recipe::Recipe& recipe, const RunOptions& options)
      : recipe_(recipe),
        options_(options),
        plan_(plan_of(recipe)),
        folder_(options.out, mapped(plan_, &PlannedStage::file)),
        progress_{0, plan_.size(), "packing", 0, 0, 0, false, false} {}

  RunOutcome outcome() {
    for (const std::string& sentence : recipe_.notices) options_.notice(sentence);
    if (const std::string sentence = folder_.what_was_put_aside(); !sentence.empty()) options_.notice(sentence);
    if (pack() && load_grains() && recipe_.has_field()) load_nodes();
    if (outcome_.interrupted) return std::move(outcome_);
    // At the very end, since a run may be killed between writing its last file and this.
    std::error_code error;
    fs::remove(folder_ / "run.checkpoint", error);
    return std::move(outcome_);
  }

 private:
  template <class Result> using Make = std::function<std::optional<Result>(const fs::path& checkpoint)>;

  /// Stage `s` of the plan; nothing, and an interrupted outcome, if it was stopped. `progress_.reused` tells where it came from.
  template <class Result> std::optional<Result> carry_out_stage(std::size_t s, const Make<Result>& make, const std::string& kernel) {
    const auto with_provenance = [&](const fs::path& checkpoint) {
      auto made = make(checkpoint);
      if (made) made->provenance = {version, plan_[s].name, plan_[s].hash, to_toml(part_of(recipe_, s)), recipe_.seed, kernel, {}};
      return made;
    };
    StageRecord<Result> stage{plan_[s], folder_ / plan_[s].file, with_provenance, nullptr, nullptr};
    if constexpr (std::is_same_v<Result, FieldResult>) stage.write = io::write_field, stage.read = io::read_field;
    else stage.write = io::write_stage, stage.read = io::read_stage;
    auto result = carry_out(stage, options_, progress_.reused);
    outcome_.interrupted = !result;
    if (result) outcome_.files.push_back(stage.file);
    return result;
  }

  bool add_stage(std::size_t s, const Make<StageResult>& make, const std::string& kernel) {
    std::optional<texture::Texture> texture;
    const auto measured = [&](const fs::path& checkpoint) {
      auto made = make(checkpoint);
      if (made && !made->frames.empty()) {
        texture = texture::measure(made->frames.back().packing, texture_options(recipe_, s));
        made->texture = texture::numbers(*texture);
        const bool was_loaded = s > 1 && !outcome_.stages.back().frames.empty();
        const Packing* before = was_loaded ? &outcome_.stages.back().frames.back().packing : nullptr;
        if (s > 0) {
          made->texture.update(fields::flow_numbers(*made, recipe_.stages[s - 1], before));
          made->texture.update(fields::cohesion_numbers(*made, recipe_.stages[s - 1], before));
        }
      }
      return made;
    };
    auto result = carry_out_stage<StageResult>(s, measured, kernel);
    if (!result) return false;
    outcome_.stages.push_back(std::move(*result));
    outcome_.measured.stages.push_back(std::move(texture));
    return true;
  }

  bool add_field(std::size_t s, const Make<FieldResult>& make) {
    begin(s);
    outcome_.measured.fields.emplace_back();
    const auto shown = [&](const fs::path& checkpoint) {
      options_.progress(progress_);
      return make(checkpoint);
    };
    auto result = carry_out_stage<FieldResult>(s, shown, "");
    if (!result) return false;
    show_done();
    outcome_.converged = outcome_.converged && result->converged;
    outcome_.fields.push_back(std::move(*result));
    return true;
  }

  void begin(std::size_t s) {
    progress_.stage = s;
    progress_.name = plan_[s].name;
    progress_.key = plan_[s].hash;
    progress_.reused = false;
    progress_.field = plan_[s].field;
    if (!plan_[s].field) return;
    progress_.share = 0;
    progress_.step = 0;
  }

  void show_done() {
    progress_.share = 1;
    options_.progress(progress_);
  }

  bool pack() {
    const auto make = [&](const fs::path&) { return std::optional(make_packing(recipe_)); };
    if (!add_stage(0, make, "")) return false;
    show_done();
    io::write_atomically(folder_ / "recipe.toml", to_toml(recipe_));
    return true;
  }

  /// All stages of loading by discrete elements; true if the run may go on.
  bool load_grains() {
    const Packing start = outcome_.stages[0].frames.back().packing;
    std::optional<dem::Engine> engine;
    std::string kernel;
    for (std::size_t s = 1; s <= recipe_.stages.size(); ++s) {
      begin(s);
      const auto make = [&](const fs::path& checkpoint) {
        if (!engine) engine.emplace(start, recipe_.contact, recipe_.integration);
        kernel = engine->kernel();
        if (s > 1) engine->restore(outcome_.stages.back().continuation);
        return load(*engine, recipe_.stages[s - 1], plan_[s].hash, checkpoint, options_, progress_);
      };
      if (!add_stage(s, make, kernel)) return false;
      if (progress_.reused) show_done();
      outcome_.converged = outcome_.stages.back().converged;
      if (!outcome_.converged) return false;
    }
    return true;
  }

  /// The cemented sample and its loads.
  void load_nodes() {
    const std::size_t first = recipe_.stages.size() + 1;
    const Packing& packing = outcome_.stages.back().frames.back().packing;
    if (!add_field(first, [&](const fs::path&) { return std::optional(make_cemented_sample(recipe_, packing)); })) return;
    const auto watch = watch_of(progress_, options_);
    std::size_t s = first;
    for (const recipe::Load& load : recipe_.loads) {
      ++s;
      const auto make = [&](const fs::path& kept) {
        const auto checkpoint = load.failure ? failure_checkpoint(kept, plan_[s].hash, options_) : FailureCheckpoint{};
        return apply_load(load, outcome_.fields.front(), watch, checkpoint, options_.page_follows ? &outcome_.measured.fields.back() : nullptr);
      };
      if (!add_field(s, make)) return;
    }
  }

  const recipe::Recipe& recipe_;
  const RunOptions& options_;
  const std::vector<PlannedStage> plan_;
  const ResultFolder folder_;
  Progress progress_;
  RunOutcome outcome_;
};

}  // namespace

RunOutcome run(const recipe::Recipe& recipe, const RunOptions& options) {
  const bool was_there = fs::exists(options.out);
  try {
    dem::find_kernel(recipe.integration.kernel);
    return Run(recipe, options).outcome();
  } catch (const InputError& error) {
    std::error_code ignored;
    if (!was_there) fs::remove(options.out, ignored);  // only if nothing is in it
    throw in_file(error, recipe.source_file);
  }
}

}  // namespace arenite::workflow
