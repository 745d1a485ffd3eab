#include "workflow/run.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/mapped.hpp"
#include "core/version.hpp"
#include "grains/dem/kernels/kernel.hpp"
#include "io/disk/file.hpp"
#include "io/results/results.hpp"
#include "workflow/cemented_sample.hpp"
#include "workflow/lammps/carry_stage.hpp"
#include "workflow/load_voxels.hpp"
#include "workflow/make_packing.hpp"
#include "workflow/read_map.hpp"
#include "workflow/runner.hpp"
#include "workflow/stage_watch.hpp"
#include "workflow/state_of_now.hpp"

namespace arenite::workflow {
namespace fs = std::filesystem;
namespace {

/// The stages of grains of an outcome.
template <int D> std::vector<StageResultIn<D>>& stages_of(RunOutcome& outcome);
template <> std::vector<StageResult>& stages_of(RunOutcome& outcome) { return outcome.stages; }
template <> std::vector<SphereResult>& stages_of(RunOutcome& outcome) { return outcome.spheres; }

/// The packing that a recipe of either dimension begins with.
template <int D> StageResultIn<D> packing_of(const recipe::Recipe& recipe);
template <> StageResult packing_of<2>(const recipe::Recipe& recipe) { return make_packing(recipe); }
template <> SphereResult packing_of<3>(const recipe::Recipe& recipe) { return make_sphere_packing(recipe); }

/// A run on its way through its plan.
class Run {
 public:
  Run(const recipe::Recipe& recipe, const RunOptions& options)
      : recipe_(recipe),
        options_(options),
        plan_(plan_of(recipe, options)),
        folder_(options.out, mapped(plan_, &PlannedStage::file)),
        progress_{.stages = plan_.size(), .name = "packing"} {}

  RunOutcome outcome() {
    for (const std::string& sentence : recipe_.notices) options_.notice(sentence);
    if (const std::string sentence = folder_.what_was_put_aside(); !sentence.empty()) options_.notice(sentence);
    if (recipe_.map) load_map(recipe_.map_beside());
    else if (recipe_.dimension == 3) void(pack<3>() && load_grains<3>() && load_cemented_spheres());
    else if (pack<2>() && load_grains<2>() && recipe_.has_field()) load_cemented();
    if (outcome_.interrupted) return std::move(outcome_);
    // At the very end, since a run may be killed between writing its last file and this.
    std::error_code error;
    fs::remove(folder_ / "run.checkpoint", error);
    return std::move(outcome_);
  }

 private:
  /// Nothing, and an interrupted outcome, if it was stopped. `progress_.reused` tells where it came from.
  template <class Result> std::optional<Result> carry_out_stage(const StageRecord<Result>& stage) {
    auto result = carry_out(stage, options_, progress_.reused);
    outcome_.interrupted = !result;
    if (result) outcome_.files.push_back(stage.file);
    return result;
  }

  template <int D, class Make> bool add_stage(std::size_t s, Make make) {
    auto& stages = stages_of<D>(outcome_);
    const bool has_before = s > 0 && !stages.back().snapshots.empty();
    const PackingIn<D>* const before = has_before ? &stages.back().snapshots.back().packing : nullptr;
    const GrainStageIn<D> stage{recipe_, s, plan_[s].hash, before, &outcome_.measured.stages.emplace_back()};
    const auto made = [&](const fs::path& checkpoint) { return make(stage, checkpoint); };
    auto result = carry_out_stage<StageResultIn<D>>(
        {plan_[s], folder_ / plan_[s].file, made, io::write_stage<D>, io::read_stage<D>});
    if (!result) {
      outcome_.measured.stages.pop_back();
      return false;
    }
    stages.push_back(std::move(*result));
    return true;
  }

  /// A result on a grid, of the plane or of space, at the end of a list.
  template <class Result, class Make>
  bool add_on_grid(std::size_t s, std::vector<Result>& list, Make make, void (*write)(const fs::path&, const Result&),
                   Result (*read)(const fs::path&)) {
    begin(s);
    const auto shown = [&](const fs::path& checkpoint) {
      options_.progress(progress_);
      std::optional<Result> made = make(checkpoint);
      if (made)
        made->provenance = {version, plan_[s].name, plan_[s].hash, to_toml(part_of(recipe_, s)), recipe_.seed, "",
                            {},      recipe_.title};
      return made;
    };
    auto result = carry_out_stage<Result>({plan_[s], folder_ / plan_[s].file, shown, write, read});
    if (!result) return false;
    show_done();
    outcome_.converged = outcome_.converged && result->converged;
    list.push_back(std::move(*result));
    return true;
  }

  template <class Make> bool add_field(std::size_t s, Make make) {
    outcome_.measured.fields.emplace_back();
    return add_on_grid<FieldResult>(s, outcome_.fields, make, io::write_field, io::read_field);
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

  template <int D> bool pack() {
    const auto make = [&](const GrainStageIn<D>& stage, const fs::path&) {
      return std::optional(measure_stage(stage, packing_of<D>(recipe_)));
    };
    if (!add_stage<D>(0, make)) return false;
    show_done();
    io::write_atomically(folder_ / "recipe.toml", to_toml(recipe_));
    return true;
  }

  /// A stage that was changed on its way is not the one that its key says; nor is then what follows.
  void tell_what_follows(std::size_t s, const std::string& made) {
    if (made == plan_[s].hash) return;
    for (std::size_t later = s + 1; later < plan_.size(); ++later)
      plan_[later].hash = HashBuilder().add("stage", plan_[later].hash).add("after", made).hex();
  }

  /// All stages of loading by discrete elements; true if the run may go on.
  template <int D> bool load_grains() {
    auto& stages = stages_of<D>(outcome_);
    const PackingIn<D> start = stages[0].snapshots.back().packing;
    if (options_.engine) require_lammps<D>(recipe_, start, *options_.engine);
    std::optional<dem::EngineIn<D>> engine;
    for (std::size_t s = 1; s <= recipe_.stages.size(); ++s) {
      begin(s);
      const auto make = [&](const GrainStageIn<D>& stage, const fs::path& checkpoint) {
        if (!engine) engine.emplace(start, recipe_.contact, recipe_.integration);
        if (s > 1) dem::restore_sample<D>(*engine, stages.back().continuation);
        return load_stage(stage, *engine, options_.on_step ? fs::path() : checkpoint, options_, progress_,
                          options_.on_step);
      };
      if (!add_stage<D>(s, make)) return false;
      tell_what_follows(s, stages.back().provenance.input_hash);
      if (progress_.reused) show_done();
      outcome_.converged = stages.back().converged;
      if (!outcome_.converged) return false;
    }
    return true;
  }

  /// The phase map, or the sample in space, and its loads.
  void load_map(const recipe::MapSection& map) {
    for (const std::string& sentence : idle_keys(map)) options_.notice("map." + sentence);
    if (is_in_space(map)) return load_space(map);
    for (const recipe::Load& load : recipe_.loads) require_length(map, load);
    if (!add_field(0, [&](const fs::path&) { return std::optional(read_sample(map, options_.notice)); })) return;
    io::write_atomically(folder_ / "recipe.toml", to_toml(recipe_));
    load_nodes(0, nullptr);
  }

  void load_space(const recipe::MapSection& map) {
    for (const recipe::Load& load : recipe_.loads) require_space(load);
    const auto make = [&] { return read_voxels(map, options_.notice); };
    load_voxels(0, make, [&] { io::write_atomically(folder_ / "recipe.toml", to_toml(recipe_)); });
  }

  bool load_cemented_spheres() {
    const PackingIn<3>& packing = outcome_.spheres.back().snapshots.back().packing;
    const auto make = [&] { return make_cemented_sample(recipe_, packing, options_.notice); };
    return load_voxels(recipe_.stages.size() + 1, make, [] {});
  }

  /// The loads of a sample in space, which is made once, from `first` of the plan on. False if it was stopped.
  template <class Make, class Done> bool load_voxels(std::size_t first, const Make& make_sample, const Done& done) {
    std::optional<VoxelMap> sample;
    const auto watch = watch_of(progress_, options_);
    for (std::size_t k = 0; k < recipe_.loads.size(); ++k) {
      const recipe::Load& load = recipe_.loads[k];
      const auto make = [&](const fs::path& kept) {
        if (!sample) sample = make_sample();
        return apply_load(load, *sample, watch, nullptr, kept_failure<3>(load, kept, plan_[first + k].hash, options_),
                          recipe_.integration.threads);
      };
      if (!add_on_grid<VoxelResult>(first + k, outcome_.voxels, make, io::write_voxels, io::read_voxels)) return false;
      done();
    }
    return true;
  }

  /// The cemented sample and its loads.
  void load_cemented() {
    const std::size_t first = recipe_.stages.size() + 1;
    const Packing& packing = outcome_.stages.back().snapshots.back().packing;
    if (!add_field(first, [&](const fs::path&) { return std::optional(make_cemented_sample(recipe_, packing)); }))
      return;
    load_nodes(first, &packing);
  }

  /// The loads on the sample at `s` of the plan; `packing` is the one that was cemented, if it was.
  void load_nodes(std::size_t s, const Packing* packing) {
    std::optional<std::vector<Tensor2>> contacts;  // for all loads that are made
    const auto stresses = [&] {
      if (!packing) return std::vector<Tensor2>{};
      const auto& texture = outcome_.measured.stages.back();
      return contact_stresses(outcome_.fields.front(), *packing,
                              texture ? texture->per_grain.sigma : std::vector<Tensor2>{});
    };
    const auto watch = watch_of(progress_, options_);
    for (const recipe::Load& load : recipe_.loads) {
      ++s;
      const auto make = [&](const fs::path& kept) {
        if (!contacts) contacts = stresses();
        const auto checkpoint = kept_failure<2>(load, kept, plan_[s].hash, options_);
        return apply_load(load, outcome_.fields.front(), watch, checkpoint,
                          options_.page_follows ? &outcome_.measured.fields.back() : nullptr, &*contacts);
      };
      if (!add_field(s, make)) return;
    }
  }

  const recipe::Recipe& recipe_;
  const RunOptions& options_;
  std::vector<PlannedStage> plan_;  ///< with other hashes behind a stage that was changed on its way
  const ResultFolder folder_;
  Progress progress_;
  RunOutcome outcome_;
};

}  // namespace

template <int D>
std::optional<StageResultIn<D>> load_stage(const GrainStageIn<D>& stage, dem::EngineIn<D>& engine,
                                           const fs::path& checkpoint, const RunOptions& options,
                                           const Progress& progress, const StepFunction* on_step) {
  dem::StageRunIn<D> run = begun_or_kept(engine, stage.recipe.stages[stage.place - 1], stage.hash, checkpoint, options);
  if (carry_by_lammps(stage, engine, run, options, progress) == Part::stopped) return std::nullopt;
  StageWatch<D> watch(stage, engine, run, options, progress, on_step);
  CheckpointTimes times(options);
  StateOfNow<D> now(stage, options.page_follows ? checkpoint.parent_path() : fs::path());
  while (!run.finished) {
    dem::continue_stage(engine, watch.stage(), run);
    watch.look();
    now.show(engine, run);
    if (run.finished || !times.is_due()) continue;
    keep(engine, run, stage.hash, checkpoint);
    if (times.asked_to_stop()) return std::nullopt;
  }
  run.result.continuation = dem::save_sample<D>(engine);
  const auto& [recipe, hash, changes] = watch.made_by();
  StageResultIn<D> made = measure_stage(GrainStageIn<D>{recipe, stage.place, hash, stage.before, stage.texture},
                                        std::move(run.result), engine.kernel->name);
  made.provenance.options = changes;
  return tell_of_lammps(std::move(made), options, stage.hash);
}
template std::optional<StageResult> load_stage(const GrainStage&, dem::Engine&, const fs::path&, const RunOptions&,
                                               const Progress&, const StepFunction*);
template std::optional<SphereResult> load_stage(const GrainStageIn<3>&, dem::EngineIn<3>&, const fs::path&,
                                                const RunOptions&, const Progress&, const StepFunction*);

RunOutcome run(const recipe::Recipe& recipe, const RunOptions& options) {
  try {
    dem::find_kernel<2>(recipe.integration.kernel);
    return Run(recipe, options).outcome();
  } catch (const InputError& error) { throw in_file(error, recipe.source_file); }
}

}  // namespace arenite::workflow
