#include "workflow/runner.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>
#include <utility>

#include "core/version.hpp"
#include "io/results/results.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;

namespace {

std::string force_at_start(int side) { return fmt::format("force_at_start {}", side_names[side]); }

constexpr std::pair<const char*, std::int64_t dem::StageRun::*> counts[] = {
    {"increment", &dem::StageRun::increment},
    {"steps_in_increment", &dem::StageRun::steps_in_increment},
    {"sample_every", &dem::StageRun::sample_every},
    {"checks", &dem::StageRun::checks},
    {"extra_states", &dem::StageRun::extra_states}};

io::Checkpoint to_checkpoint(const dem::Engine& engine, const dem::StageRun& run, const std::string& key) {
  io::Checkpoint checkpoint;
  checkpoint.key = key;
  checkpoint.blobs["engine"] = save_sample(engine);
  for (int side = 0; side < sides; ++side) checkpoint.numbers[force_at_start(side)] = run.start.force[side];
  for (const auto& [name, count] : counts) checkpoint.integers[name] = run.*count;
  checkpoint.partial = run.result;
  return checkpoint;
}

void restore_from(const io::Checkpoint& checkpoint, dem::Engine& engine, dem::StageRun& run) {
  restore_sample(engine, checkpoint.blobs.at("engine"));
  for (int side = 0; side < sides; ++side) run.start.force[side] = checkpoint.numbers.at(force_at_start(side));
  for (const auto& [name, count] : counts)
    if (const auto at = checkpoint.integers.find(name); at != checkpoint.integers.end()) run.*count = at->second;
  run.result = checkpoint.partial;
}

}  // namespace

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

CheckpointTimes::CheckpointTimes(const RunOptions& options)
    : options_(options),
      last_(std::chrono::steady_clock::now()) {}

bool CheckpointTimes::is_due() {
  const auto now = std::chrono::steady_clock::now();
  asked_to_stop_ = options_.asked_to_stop();
  const bool due = asked_to_stop_ || std::chrono::duration<double>(now - last_).count() >= options_.checkpoint_seconds;
  if (due) last_ = now;
  return due;
}

History convergence_of(const std::vector<double>& residuals) {
  std::vector<double> iteration;
  for (std::size_t k = 0; k < residuals.size(); ++k) iteration.push_back(static_cast<double>(k));
  return {{{"iteration", "1", std::move(iteration)}, {"residual", "1", residuals}}};
}

Provenance provenance_of(const recipe::MapSection& map, const recipe::Load& load, const std::string& hash) {
  return {version,
          load.name,
          hash,
          "",
          0,
          "",
          {{"map", fs::path(map.file).filename().string()}, {"options", told_map_keys(map)}}};
}

peridynamics::Watch watch_of(Progress& progress, const RunOptions& options) {
  return [&](const peridynamics::Progress& p) {
    progress.share = std::min(p.share, 0.999);
    progress.step = p.iterations;
    progress.residual = p.residual;
    options.progress(progress);
    return !options.asked_to_stop();
  };
}

dem::StageRun begun_or_kept(dem::Engine& engine, const dem::Stage& stage, const std::string& key, const fs::path& file,
                            const RunOptions& options) {
  dem::StageRun run = dem::begin_stage(engine, stage);
  const auto kept =
      unless_damaged(file, options, "the stage starts again", [&] { return io::read_checkpoint(file, key); });
  if (kept && *kept) restore_from(**kept, engine, run);
  return run;
}

void keep(const dem::Engine& engine, const dem::StageRun& run, const std::string& key, const fs::path& file) {
  if (!file.empty()) io::write_checkpoint(file, to_checkpoint(engine, run, key));
}

FailureCheckpoint failure_checkpoint(const std::filesystem::path& file, const std::string& key,
                                     const RunOptions& options) {
  FailureCheckpoint checkpoint;
  const auto stored =
      unless_damaged(file, options, "the test starts again", [&] { return io::read_checkpoint(file, key); });
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
