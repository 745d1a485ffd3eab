#include "workflow/runner.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/version.hpp"
#include "io/results/results.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;

bool Claim::taken_from_store(const fs::path& file) {
  const Store* const store = options_.store;
  if (!store) return false;
  make_folder(file.parent_path());
  lock_.reset();
  while (!fetch(file)) {
    lock_ = store->try_claim(stage_.hash);
    if (lock_) {
      // It may have come between the look and the lock.
      if (!fetch(file)) break;
      lock_.reset();
      return true;
    }
    if (options_.asked_to_stop()) {
      stopped = true;
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  began_ = std::clock();
  return !lock_;
}

bool Claim::fetch(const fs::path& file) const {
  return options_.store->fetch(stage_.hash, file) || (!stage_.former_hash.empty() && options_.store->fetch(stage_.former_hash, file));
}

void Claim::drop_stored() const {
  options_.store->drop(stage_.hash);
  if (!stage_.former_hash.empty()) options_.store->drop(stage_.former_hash);
}

fs::path Claim::checkpoint(const fs::path& without_store) const { return options_.store ? options_.store->checkpoint(stage_.hash) : without_store; }

void Claim::computed(const fs::path& file) const {
  if (!options_.store) return;
  options_.store->put(stage_.hash, file);
  options_.store->note_computed(stage_, seconds());
}

void Claim::interrupted() const {
  if (options_.store) options_.store->note_begun(stage_, seconds());
}

Provenance provenance_of(const recipe::Recipe& recipe, std::size_t s, const PlannedStage& stage, const std::string& kernel) {
  return {version, stage.name, stage.hash, to_toml(part_of(recipe, s)), recipe.seed, kernel, {}};
}

CheckpointTimes::CheckpointTimes(const RunOptions& options) : options_(options), last_(std::chrono::steady_clock::now()) {}

bool CheckpointTimes::is_due() {
  const auto now = std::chrono::steady_clock::now();
  asked_to_stop_ = options_.asked_to_stop();
  const bool due = asked_to_stop_ || std::chrono::duration<double>(now - last_).count() >= options_.checkpoint_seconds;
  if (due) last_ = now;
  return due;
}

peridynamics::Watch watch_of(Progress& progress, const RunOptions& options) {
  return [&](const peridynamics::Progress& p) {
    progress.share = std::min(p.share, 0.999);
    progress.step = p.iterations;
    progress.unbalanced_ratio = p.residual;
    options.progress(progress);
    return !options.asked_to_stop();
  };
}

FailureCheckpoint failure_checkpoint(const std::filesystem::path& file, const std::string& key, const RunOptions& options) {
  FailureCheckpoint checkpoint;
  const auto stored = unless_damaged(file, options, "the test begins anew", [&] { return io::read_checkpoint(file, key); });
  if (stored && *stored) checkpoint.resume = peridynamics::failure_state_of((*stored)->blobs.at("pull"));
  checkpoint.keep = [file, key, times = CheckpointTimes(options)](const auto& state) mutable {
    if (!times.is_due()) return;
    io::Checkpoint c;
    c.key = key;
    c.blobs["pull"] = to_bytes(state());
    make_folder(file.parent_path());
    io::write_checkpoint(file, c);
  };
  return checkpoint;
}

}  // namespace arenite::workflow
