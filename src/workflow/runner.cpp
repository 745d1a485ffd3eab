#include "workflow/runner.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include "io/results/results.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;

Turn wait_for_turn(const PlannedStage& stage, const fs::path& file, const RunOptions& options) {
  const Store* const store = options.store;
  if (!store) return {};
  make_folder(file.parent_path());
  while (!store->fetch(stage.hash, file)) {
    if (auto lock = store->try_claim(stage.hash)) {
      // It may have come between the look and the lock.
      if (store->fetch(stage.hash, file)) break;
      return {.lock = std::move(lock)};
    }
    if (options.asked_to_stop()) return {.stopped = true};
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return {.fetched = true};
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
