#include <chrono>
#include <filesystem>

#include "io/checkpoint.hpp"
#include "io/field_file.hpp"
#include "study/field_stages.hpp"
#include "study/stored.hpp"

namespace arenite::study {
namespace {

namespace fs = std::filesystem;

std::optional<FieldResult> stored_field(const fs::path& file, const RunOptions& options) {
  if (!fs::exists(file)) return std::nullopt;
  return unless_damaged(file, options, "this stage is computed again", [&] { return io::read_field(file); });
}

/// Reads a result, or makes, writes and reads it: what follows sees the same numbers either way. False if it was stopped.
template <class Make>
bool add_field(const fs::path& file, const std::string& stage, const std::string& hash, const Recipe& recipe, const RunOptions& options,
               Progress& progress, RunOutcome& outcome, Make make) {
  ++progress.stage;
  progress.name = stage;
  progress.share = 0;
  progress.step = 0;
  auto stored = stored_field(file, options);
  progress.reused = stored.has_value();
  if (!stored) {
    options.progress(progress);
    auto result = make();
    if (!result) {
      outcome.interrupted = true;
      return false;
    }
    result->provenance = provenance_of(recipe, stage, hash, "");
    io::write_field(file, *result);
    stored = io::read_field(file);
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

void run_fields(const Recipe& recipe, const std::vector<std::string>& hashes, const std::vector<std::string>& names,
                const ResultFolder& folder, const RunOptions& options, Progress progress, RunOutcome& outcome) {
  progress.stage = recipe.stages.size();
  progress.field = true;
  const Packing& packing = outcome.stages.back().frames.back().packing;
  if (!add_field(folder / names[0], "cement", hashes[0], recipe, options, progress, outcome,
                 [&] { return std::optional(make_cemented_sample(recipe, packing)); }))
    return;
  for (std::size_t l = 0; l < recipe.loads.size(); ++l) {
    const Load& load = recipe.loads[l];
    const auto watch = [&](const peridynamics::Progress& p) {
      progress.share = std::min(p.share, 0.999);
      progress.step = p.iterations;
      progress.unbalanced_ratio = p.residual;
      options.progress(progress);
      return !options.asked_to_stop();
    };
    if (!add_field(folder / names[l + 1], load.name, hashes[l + 1], recipe, options, progress, outcome,
                   [&] {
                     const auto checkpoint = load.failure ? checkpoint_of(folder / "run.checkpoint", hashes[l + 1], options) : PullCheckpoint{};
                     return apply_load(load, outcome.fields.front(), watch, checkpoint);
                   }))
      return;
  }
}

}  // namespace arenite::study
