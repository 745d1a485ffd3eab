#include "workflow/lammps/carry_stage.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/mapped.hpp"
#include "core/option.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/dem/history/history.hpp"
#include "grains/lammps/carried.hpp"
#include "grains/lammps/deck.hpp"
#include "grains/lammps/expressible.hpp"
#include "io/disk/file.hpp"
#include "workflow/lammps/job.hpp"
#include "workflow/lammps/read_carried.hpp"
#include "workflow/runner.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;

namespace {

/// Steps of a leg of a time that are left to our own engine, so that the state at its end is one that it made.
constexpr std::int64_t own_steps = 200;
constexpr const char* agreement_file = "agreement";
constexpr double widest_in_part = 2.2;      ///< diameters of the largest grain that the part of a process must have
constexpr double much_disagreement = 0.05;  ///< of the mean force; grains in motion and springs of friction make less

fs::path folder_of(const RunOptions& options, const std::string& hash) {
  return options.out / "lammps" / hash.substr(0, 12);
}

/// Friction that springs of contacts hold; by more than what rounding leaves of none.
template <int D> bool has_loaded_springs(const dem::SampleIn<D>& s) {
  const bool remembers = s.laws.friction.visit([](const auto& friction) { return friction.remembers; });
  return remembers && (s.friction > 0 || s.wall_friction > 0) && dem::equilibrium_of<D>(s).mobilisation > 1e-9;
}

lammps::Task task_of(const dem::Stage& stage, const dem::Leg& leg, const EngineOptions& options) {
  lammps::Task task{.title = fmt::format("Stage {}, {}", stage.name, leg.label), .leg = leg, .rest = stage.equilibrium};
  task.restart_every = options.restart_every;
  task.to_rest = !leg.until;
  task.steps = leg.until ? *leg.until - own_steps : stage.equilibrium.max_steps;
  return task;
}

std::string sentence_of(const lammps::Agreement& agreement, std::int64_t steps, const std::string& version) {
  std::string text = fmt::format(
      "carried {} steps by {}; of {} contacts, all computed anew by our law, the resultants on grains differ from its "
      "own by at most {:.1e} of the mean contact force; unbalanced force ratio {:.1e}",
      steps, version, agreement.contacts, agreement.largest, agreement.unbalanced);
  if (agreement.not_there > 0) text += fmt::format("; {} contacts are in one of the two alone", agreement.not_there);
  if (agreement.largest > much_disagreement)
    text += "; that is more than rounding makes: do not trust LAMMPS's way, take fewer processes or run the stage here";
  return text;
}

}  // namespace

template <int D>
void require_lammps(const recipe::Recipe& recipe, const PackingIn<D>& start, const EngineOptions& options) {
  if (!options.is_lammps()) return;
  const auto names = mapped(recipe.stages, &dem::Stage::name);
  Problems problems;
  for (const std::string& name : options.stages)
    problems.unless(std::ranges::count(names, name) > 0, "there is no stage \"{}\" for LAMMPS to run; there are {}",
                    name, list_of(names));
  for (const dem::Stage& stage : recipe.stages) {
    if (!options.carries(stage.name)) continue;
    for (const std::string& sentence : lammps::inexpressible(start, recipe.contact, recipe.integration, stage))
      problems.add("stage \"{}\": {}", stage.name, sentence);
  }
  // In narrower parts LAMMPS of 2021 was seen to lose contacts across two borders.
  const double widest = start.grains.size() > 0 ? 2 * std::ranges::max(start.grains.radius) : 0;
  const double part = lammps::narrowest_part<D>(start.domain, options.ranks);
  problems.unless(!options.command.empty() || part >= widest_in_part * widest,
                  "{} processes have parts of {:.3g} mm, narrower than {:g} of the largest grains; give fewer {}",
                  options.ranks, 1e3 * part, widest_in_part, option("ranks"));
  problems.raise();
}

std::vector<PlannedStage> plan_of(const recipe::Recipe& recipe, const RunOptions& options) {
  std::vector<PlannedStage> plan = plan_of(recipe);
  if (!options.engine || !options.engine->is_lammps()) return plan;
  if (options.on_step) throw InputError("on_step is not called while LAMMPS runs a stage; leave out one of the two");
  bool is_other = false;
  for (std::size_t s = 1; s < plan.size(); ++s) {
    const bool carried = s <= recipe.stages.size() && options.engine->carries(recipe.stages[s - 1].name);
    is_other = is_other || carried;
    if (!is_other) continue;
    const std::string hash = HashBuilder().add("stage", plan[s].hash).add("engine", carried ? "lammps" : "after").hex();
    plan[s] = planned_stage(static_cast<int>(s) + 1, plan[s].name, hash, plan[s].field);
  }
  return plan;
}

template <int D>
Part carry_by_lammps(const GrainStageIn<D>& stage, dem::EngineIn<D>& engine, dem::StageRunIn<D>& run,
                     const RunOptions& options, const Progress& progress) {
  if (!options.engine || run.steps_in_increment > 0 || run.increment > 0) return Part::none;
  const dem::Stage& loading = stage.recipe.stages[stage.place - 1];
  if (!options.engine->carries(loading.name)) return Part::none;
  if (has_loaded_springs<D>(engine)) {
    options.notice(fmt::format(
        "stage \"{}\" begins with springs of friction, which LAMMPS cannot be given: it runs here", loading.name));
    return Part::none;
  }
  const dem::Leg leg = dem::leg_at(loading, run.start, 0, 0, engine.dt);
  dem::set_drives<D>(engine, dem::drives_for<D>(loading, leg, engine.domain));
  const lammps::Task task = task_of(loading, leg, *options.engine);
  if (task.steps <= 0) return Part::none;
  const LammpsJob job(folder_of(options, stage.hash), lammps::deck_of<D>(engine, task), loading.name, *options.engine);
  if (!job.has_ended()) {
    if (options.engine->prepare || !job.can_start()) {
      options.notice(
          fmt::format("LAMMPS's files are in {0}; run them by `cd {0} && sbatch job.sh` or `bash job.sh`, "
                      "then give the same command again{1}",
                      job.folder().string(),
                      options.engine->prepare ? " without " + option("prepare")
                                              : fmt::format(": {} is not here", options.engine->line())));
      return Part::stopped;
    }
    Progress now = progress;
    const auto tell = [&](std::int64_t step) {
      now.step = engine.step + step;
      options.progress(now);
    };
    if (!job.run(options.asked_to_stop, tell)) return Part::stopped;
  }
  const auto carried = read_carried<D>(job.folder(), engine);
  const lammps::Agreement agreement = lammps::take_over<D>(engine, carried);
  run.steps_in_increment = carried.steps;
  run.latest = dem::equilibrium_of<D>(engine);
  dem::add_row<D>(run.result.history, {engine, loading, run.latest, run.increment});
  const std::string sentence = sentence_of(agreement, carried.steps, job.version());
  io::write_atomically(job.folder() / agreement_file, sentence);
  options.notice(fmt::format("stage \"{}\" was {}", loading.name, sentence));
  return Part::carried;
}

template <int D>
StageResultIn<D> tell_of_lammps(StageResultIn<D> made, const RunOptions& options, const std::string& hash) {
  const fs::path file = options.engine ? folder_of(options, hash) / agreement_file : fs::path();
  if (!fs::exists(file)) return made;
  const std::string sentence = io::read_file(file);
  made.outcome += "; " + sentence;
  made.provenance.options.emplace_back("engine", sentence);
  return made;
}

#define ARENITE_OF(D)                                                                                              \
  template void require_lammps(const recipe::Recipe&, const PackingIn<D>&, const EngineOptions&);                  \
  template Part carry_by_lammps(const GrainStageIn<D>&, dem::EngineIn<D>&, dem::StageRunIn<D>&, const RunOptions&, \
                                const Progress&);                                                                  \
  template StageResultIn<D> tell_of_lammps(StageResultIn<D>, const RunOptions&, const std::string&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::workflow
