#include <chrono>
#include <filesystem>

#include "io/checkpoint.hpp"
#include "io/field_file.hpp"
#include "workflow/field_stages.hpp"
#include "workflow/stored.hpp"

namespace arenite::study {
namespace {

namespace fs = std::filesystem;

/// Reads a result, or makes, writes and reads it: what follows sees the same numbers either way. False if it was stopped.
/// `make` is told where its checkpoint lies.
template <class Make>
bool add_field(const fs::path& file, std::size_t s, const PlannedStage& stage, const Recipe& recipe, const RunOptions& options,
               Progress& progress, RunOutcome& outcome, Make make) {
  ++progress.stage;
  progress.name = stage.name;
  progress.share = 0;
  progress.step = 0;
  Claim claim(options, stage);
  auto stored = stored_or_claimed(file, options, stage, claim, io::read_field);
  progress.reused = stored.has_value();
  if (!stored && !claim.stopped) {
    options.progress(progress);
    auto result = make(claim.checkpoint(file.parent_path() / "run.checkpoint"));
    if (!result) claim.interrupted();
    if (result) {
      result->provenance = provenance_of(recipe, s, stage, "");
      io::write_field(file, *result);
      claim.computed(file);
      stored = io::read_field(file);
    }
  }
  if (!stored) {
    outcome.interrupted = true;
    return false;
  }
  progress.share = 1;
  options.progress(progress);
  outcome.files.push_back(file);
  outcome.converged = outcome.converged && stored->converged;
  outcome.fields.push_back(std::move(*stored));
  return true;
}

/// Where a killed pull stood, and how this one is kept: every few seconds, and when it is asked to stop.
PullCheckpoint checkpoint_of(const fs::path& file, const std::string& key, const RunOptions& options) {
  using clock = std::chrono::steady_clock;
  PullCheckpoint checkpoint;
  const auto stored = unless_damaged(file, options, "the pull begins anew", [&] { return io::read_checkpoint(file, key); });
  if (stored && *stored) checkpoint.resume = peridynamics::pull_state_of((*stored)->blobs.at("pull"));
  checkpoint.keep = [&options, file, key, saved = clock::now()](const auto& state) mutable {
    if (!options.asked_to_stop() && std::chrono::duration<double>(clock::now() - saved).count() < options.checkpoint_seconds) return;
    io::Checkpoint c;
    c.key = key;
    c.blobs["pull"] = to_bytes(state());
    io::write_checkpoint(file, c);
    saved = clock::now();
  };
  return checkpoint;
}

}  // namespace

void run_fields(const Recipe& recipe, const std::vector<PlannedStage>& plan, const ResultFolder& folder, const RunOptions& options,
                Progress progress, RunOutcome& outcome) {
  const std::size_t first = recipe.stages.size() + 1;
  progress.stage = recipe.stages.size();
  progress.field = true;
  const Packing& packing = outcome.stages.back().frames.back().packing;
  if (!add_field(folder / plan[first].file, first, plan[first], recipe, options, progress, outcome,
                 [&](const fs::path&) { return std::optional(make_cemented_sample(recipe, packing)); }))
    return;
  for (std::size_t l = 0; l < recipe.loads.size(); ++l) {
    const Load& load = recipe.loads[l];
    const PlannedStage& stage = plan[first + 1 + l];
    const auto watch = [&](const peridynamics::Progress& p) {
      progress.share = std::min(p.share, 0.999);
      progress.step = p.iterations;
      progress.unbalanced_ratio = p.residual;
      options.progress(progress);
      return !options.asked_to_stop();
    };
    const auto make = [&](const fs::path& kept) {
      const auto checkpoint = load.failure ? checkpoint_of(kept, stage.hash, options) : PullCheckpoint{};
      return apply_load(load, outcome.fields.front(), watch, checkpoint);
    };
    if (!add_field(folder / stage.file, first + 1 + l, stage, recipe, options, progress, outcome, make))
      return;
  }
}

}  // namespace arenite::study
