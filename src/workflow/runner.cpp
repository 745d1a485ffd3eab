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

std::string force_at_start(int side) { return fmt::format("force_at_start {}", any_side_names[side]); }

template <int D>
constexpr std::pair<const char*, std::int64_t dem::StageRunIn<D>::*> counts[] = {
    {"increment", &dem::StageRunIn<D>::increment},
    {"steps_in_increment", &dem::StageRunIn<D>::steps_in_increment},
    {"sample_every", &dem::StageRunIn<D>::sample_every},
    {"checks", &dem::StageRunIn<D>::checks},
    {"extra_states", &dem::StageRunIn<D>::extra_states}};

template <int D>
io::CheckpointIn<D> to_checkpoint(const dem::EngineIn<D>& engine, const dem::StageRunIn<D>& run,
                                  const std::string& key) {
  io::CheckpointIn<D> checkpoint;
  checkpoint.key = key;
  checkpoint.blobs["engine"] = dem::save_sample<D>(engine);
  for (int side = 0; side < sides_in<D>; ++side) checkpoint.numbers[force_at_start(side)] = run.start.force[side];
  for (const auto& [name, count] : counts<D>) checkpoint.integers[name] = run.*count;
  checkpoint.partial = run.result;
  return checkpoint;
}

template <int D>
void restore_from(const io::CheckpointIn<D>& checkpoint, dem::EngineIn<D>& engine, dem::StageRunIn<D>& run) {
  dem::restore_sample<D>(engine, checkpoint.blobs.at("engine"));
  for (int side = 0; side < sides_in<D>; ++side) run.start.force[side] = checkpoint.numbers.at(force_at_start(side));
  for (const auto& [name, count] : counts<D>)
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

template <int D>
dem::StageRunIn<D> begun_or_kept(dem::EngineIn<D>& engine, const dem::Stage& stage, const std::string& key,
                                 const fs::path& file, const RunOptions& options) {
  dem::StageRunIn<D> run = dem::begin_stage(engine, stage);
  const auto kept =
      unless_damaged(file, options, "the stage starts again", [&] { return io::read_checkpoint<D>(file, key); });
  if (kept && *kept) restore_from(**kept, engine, run);
  return run;
}

template <int D>
void keep(const dem::EngineIn<D>& engine, const dem::StageRunIn<D>& run, const std::string& key, const fs::path& file) {
  if (!file.empty()) io::write_checkpoint(file, to_checkpoint(engine, run, key));
}

template <int D>
void note_progress(const dem::EngineIn<D>& engine, const dem::Stage& stage, const dem::StageRunIn<D>& run,
                   Progress& progress) {
  progress.share = dem::share_done(stage, run);
  if (stage.duration && !run.finished)
    progress.share = std::max(
        progress.share, std::min(0.999, static_cast<double>(run.steps_in_increment) * engine.dt / *stage.duration));
  progress.increment = std::min(run.increment + 1, progress.increments);
  progress.unbalanced_ratio = run.latest.unbalanced_ratio;
  progress.step = engine.step;
  progress.time = dem::time_of<D>(engine);
}

template <int D>
FailureCheckpointIn<D> failure_checkpoint(const std::filesystem::path& file, const std::string& key,
                                          const RunOptions& options) {
  FailureCheckpointIn<D> checkpoint;
  const auto stored =
      unless_damaged(file, options, "the test starts again", [&] { return io::read_checkpoint(file, key); });
  if (stored && *stored) checkpoint.resume = peridynamics::failure_state_of<D>((*stored)->blobs.at("pull"));
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

#define ARENITE_OF(D)                                                                                                  \
  template dem::StageRunIn<D> begun_or_kept(dem::EngineIn<D>&, const dem::Stage&, const std::string&, const fs::path&, \
                                            const RunOptions&);                                                        \
  template void keep(const dem::EngineIn<D>&, const dem::StageRunIn<D>&, const std::string&, const fs::path&);         \
  template void note_progress(const dem::EngineIn<D>&, const dem::Stage&, const dem::StageRunIn<D>&, Progress&);       \
  template FailureCheckpointIn<D> failure_checkpoint(const fs::path&, const std::string&, const RunOptions&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::workflow
