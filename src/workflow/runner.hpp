#pragma once
#include <fmt/core.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grains/dem/run_stage.hpp"
#include "io/disk/store_file.hpp"
#include "workflow/apply_load.hpp"
#include "workflow/result_folder.hpp"
#include "workflow/run.hpp"
#include "workflow/stage_keys.hpp"
#include "workflow/store.hpp"

// The one way in which results come to be, or are taken from where they are.
namespace arenite::workflow {

/// What `read` gives; nothing, and a notice, if its file is damaged.
template <class Read>
auto unless_damaged(const std::filesystem::path& file, const RunOptions& options, const char* instead, Read read)
    -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const io::DamagedFile&) {
    options.notice(fmt::format("{}: is empty, truncated or changed; {}", file.string(), instead));
    return std::nullopt;
  }
}

/// Whose turn it is to make a stage that several may want at once.
struct Turn {
  bool fetched = false;                   ///< it came from the store into the folder
  bool stopped = false;                   ///< neither, for this process was asked to stop
  std::optional<io::FileLock> lock = {};  ///< else it is made here, under this lock where there is a store
};
/// Waits until one of these is so.
Turn wait_for_turn(const PlannedStage& stage, const std::filesystem::path& file, const RunOptions& options);

/// A stage: what it is called, where its result lies, and how that is made, written and read. A new kind of stage is
/// one such record.
template <class Result> struct StageRecord {
  PlannedStage key;
  std::filesystem::path file;
  std::function<std::optional<Result>(const std::filesystem::path& checkpoint)> make;  ///< nothing if it was stopped
  void (*write)(const std::filesystem::path&, const Result&);
  Result (*read)(const std::filesystem::path&);
  const char* again = "this stage is computed again";  ///< what is said to follow where a file is damaged
};

/// Carries out a stage: its result comes from the run's folder, or from the store, or is made, written and read, so
/// that what follows sees the same numbers either way. Of those who want it at once one makes it. `reused` says that it
/// was there; nothing if it was stopped.
template <class Result>
std::optional<Result> carry_out(const StageRecord<Result>& stage, const RunOptions& options, bool& reused) {
  const auto look = [&]() -> std::optional<Result> {
    if (!std::filesystem::exists(stage.file)) return std::nullopt;
    auto found = unless_damaged(stage.file, options, stage.again, [&] { return stage.read(stage.file); });
    if (found && found->provenance.input_hash != stage.key.hash) found.reset();  // names hold a part of the hash only
    return found;
  };
  const Store* const store = options.store;
  const auto keep_in_store = [&] {
    if (store && !store->has(stage.key.hash)) store->put(stage.key.hash, stage.file);
  };
  reused = true;
  if (auto here = look()) {
    keep_in_store();
    return here;
  }
  Turn turn;
  while ((turn = wait_for_turn(stage.key, stage.file, options)).fetched) {
    if (auto fetched = look()) {
      keep_in_store();
      store->note(Store::Event::reused, stage.key);
      return fetched;
    }
    store->drop(stage.key.hash);
  }
  reused = false;
  if (turn.stopped) return std::nullopt;
  const std::clock_t began = std::clock();
  const auto seconds = [&] { return static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC; };
  const auto made = stage.make(store ? store->checkpoint(stage.key.hash) : stage.file.parent_path() / "run.checkpoint");
  if (!made) {
    if (store) store->note(Store::Event::begun, stage.key, seconds());
    return std::nullopt;
  }
  make_folder(stage.file.parent_path());
  stage.write(stage.file, *made);
  if (store && made->provenance.input_hash == stage.key.hash) {
    store->put(stage.key.hash, stage.file);
    store->note(Store::Event::computed, stage.key, seconds());
  }
  return stage.read(stage.file);
}

/// Shows how far a load has come, by its iterations and residual, and stops it where that is asked for.
peridynamics::Watch watch_of(Progress& progress, const RunOptions& options);

/// What made the result of a load of a map by itself, whose name is `hash`.
Provenance provenance_of(const recipe::MapSection& map, const recipe::Load& load, const std::string& hash);

/// A load of a map by itself, of the plane or of space.
template <class Result> struct LoadedMap {
  std::optional<Result> result;  ///< nothing if it was stopped
  std::filesystem::path file;    ///< empty where nothing is stored
};
/// The result is one file in `options.out`, taken from there if it was computed before; without that folder nothing is
/// stored. `make(watch, hash, checkpoint)` reads the map and loads it.
template <class Result, class Make>
LoadedMap<Result> load_by_itself(const recipe::MapSection& map, const recipe::Load& load, const RunOptions& options,
                                 Make make, void (*write)(const std::filesystem::path&, const Result&),
                                 Result (*read)(const std::filesystem::path&)) {
  for (const std::string& sentence : load.idle_keys()) options.notice(sentence);
  const PlannedStage stage = planned_stage(1, load.name, load_key(load, map_key(map)), true);
  Progress progress{.stage = 1, .stages = 1, .name = load.name, .field = true};
  const auto made = [&](const std::filesystem::path& checkpoint) {
    std::optional<Result> result = make(watch_of(progress, options), stage.hash, checkpoint);
    if (result) result->provenance = provenance_of(map, load, stage.hash);
    return result;
  };
  LoadedMap<Result> loaded;
  if (options.out.empty()) {
    loaded.result = made({});
  } else {
    loaded.file = options.out / stage.file;
    loaded.result = carry_out<Result>({stage, loaded.file, made, write, read}, options, progress.reused);
  }
  if (!loaded.result) return loaded;
  progress.share = 1;
  options.progress(progress);
  return loaded;
}

/// When a stage that takes long is kept on its way, so that it goes on there when it was killed: every
/// `checkpoint_seconds`, and when it is asked to stop.
class CheckpointTimes {
 public:
  explicit CheckpointTimes(const RunOptions& options);
  bool is_due();
  bool asked_to_stop() const { return asked_to_stop_; }  ///< when is_due was asked last

 private:
  const RunOptions& options_;
  std::chrono::steady_clock::time_point last_;
  bool asked_to_stop_ = false;
};

/// The residuals of a solve as a history.
History convergence_of(const std::vector<double>& residuals);

/// A stage of loading by discrete elements, at its begin or where it was kept by its file.
template <int D>
dem::StageRunIn<D> begun_or_kept(dem::EngineIn<D>& engine, const dem::Stage& stage, const std::string& key,
                                 const std::filesystem::path& file, const RunOptions& options);

/// Keeps it there; nowhere if `file` is empty.
template <int D>
void keep(const dem::EngineIn<D>& engine, const dem::StageRunIn<D>& run, const std::string& key,
          const std::filesystem::path& file);

/// Where a stage of loading by discrete elements stands; finer than by the states that it stores.
template <int D>
void note_progress(const dem::EngineIn<D>& engine, const dem::Stage& stage, const dem::StageRunIn<D>& run,
                   Progress& progress);

/// Where a killed test stood by its file, and how this one is kept there.
template <int D>
FailureCheckpointIn<D> failure_checkpoint(const std::filesystem::path& file, const std::string& key,
                                          const RunOptions& options);
/// The same of a load that may be one, with nothing kept where `file` is empty.
template <int D>
FailureCheckpointIn<D> kept_failure(const recipe::Load& load, const std::filesystem::path& file, const std::string& key,
                                    const RunOptions& options) {
  return load.failure && !file.empty() ? failure_checkpoint<D>(file, key, options) : FailureCheckpointIn<D>{};
}

}  // namespace arenite::workflow
