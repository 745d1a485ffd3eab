#include "workflow/checkpoints.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/results/results.hpp"
#include "workflow/runner.hpp"

namespace arenite::workflow {
namespace {

std::string force_at_start(int side) { return fmt::format("force_at_start {}", side_names[side]); }

using dem::StageRun;
constexpr std::pair<const char*, std::int64_t StageRun::*> counts[] = {{"increment", &StageRun::increment},
                                                                       {"steps_in_increment", &StageRun::steps_in_increment},
                                                                       {"sample_every", &StageRun::sample_every},
                                                                       {"checks", &StageRun::checks}};

}  // namespace

CheckpointTimes::CheckpointTimes(const RunOptions& options) : options_(options), last_(std::chrono::steady_clock::now()) {}

bool CheckpointTimes::is_due() {
  const auto now = std::chrono::steady_clock::now();
  asked_to_stop_ = options_.asked_to_stop();
  const bool due = asked_to_stop_ || std::chrono::duration<double>(now - last_).count() >= options_.checkpoint_seconds;
  if (due) last_ = now;
  return due;
}

io::Checkpoint to_checkpoint(const dem::Engine& engine, const dem::StageRun& run, const std::string& key) {
  io::Checkpoint checkpoint;
  checkpoint.key = key;
  checkpoint.blobs["engine"] = engine.save();
  for (int side = 0; side < 4; ++side) checkpoint.numbers[force_at_start(side)] = run.force_at_start[side];
  for (const auto& [name, count] : counts) checkpoint.integers[name] = run.*count;
  checkpoint.partial = run.result;
  return checkpoint;
}

void restore_from(const io::Checkpoint& checkpoint, dem::Engine& engine, dem::StageRun& run) {
  engine.restore(checkpoint.blobs.at("engine"));
  for (int side = 0; side < 4; ++side) run.force_at_start[side] = checkpoint.numbers.at(force_at_start(side));
  for (const auto& [name, count] : counts) run.*count = checkpoint.integers.at(name);
  run.result = checkpoint.partial;
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
