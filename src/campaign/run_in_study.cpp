#include "campaign/run_in_study.hpp"

#include <ctime>
#include <exception>
#include <new>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/file_lock.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::study {
namespace {

using Kind = RunState::Kind;

/// The stage that ended the run, and how.
std::string why_unfinished(const RunOutcome& outcome) {
  for (const auto& stage : outcome.stages)
    if (!stage.converged) return stage.name + ": " + stage.outcome;
  for (const auto& field : outcome.fields)
    if (!field.converged) return field.name + ": " + field.outcome;
  return "it did not converge";
}

RunState attempt(const Study& study, const StudyRun& run, const StudyFolder& folder, const Store& store, const StudyOptions& options) {
  Recipe recipe = recipe_of(study, run);
  recipe.integration.threads = options.threads;
  RunOptions run_options;
  run_options.out = folder.run(run.name);
  run_options.store = &store;
  run_options.checkpoint_seconds = options.checkpoint_seconds;
  run_options.asked_to_stop = options.asked_to_stop;
  run_options.notice = options.notice;
  const RunOutcome outcome = study::run(recipe, run_options);
  if (outcome.interrupted) return {};
  io::write_atomically(folder.numbers(run.name), to_json(options.numbers(outcome), 2) + "\n");
  if (outcome.converged) return {Kind::done, 0, {}};
  return {Kind::unfinished, 0, why_unfinished(outcome)};
}

RunState attempt_whatever_happens(const Study& study, const StudyRun& run, const StudyFolder& folder, const Store& store, const StudyOptions& options) {
  try {
    return attempt(study, run, folder, store, options);
  } catch (const InputError& error) {
    return {Kind::failed, 0, error.what()};
  } catch (const std::bad_alloc&) {
    return {Kind::failed, 0, "the memory does not suffice; do fewer runs at once (--jobs)"};
  } catch (const std::exception& error) {
    return {Kind::failed, 0, error.what()};
  }
}

}  // namespace

std::optional<RunState> run_in_study(const Study& study, const StudyRun& run, const StudyFolder& folder, const Store& store,
                                     const io::AppendLog& journal, const StudyOptions& options) {
  const auto lock = io::FileLock::try_take(folder.lock(run.name));
  if (!lock) return std::nullopt;
  // Another process may have done it since it was chosen.
  if (const auto status = read_status(folder, run.name); status && status->settled() && !(options.retry && status->kind != Kind::done)) return status;
  note_state(journal, run.name, {Kind::running, 0, {}});
  const std::clock_t began = std::clock();
  RunState state = attempt_whatever_happens(study, run, folder, store, options);
  state.seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  if (state.settled()) {
    make_folder(folder.run(run.name));
    write_status(folder, run.name, state);
  }
  note_state(journal, run.name, state);
  return state;
}

}  // namespace arenite::study
