#pragma once
#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "io/disk/store_file.hpp"
#include "workflow/field_stages.hpp"
#include "workflow/result_folder.hpp"
#include "workflow/run.hpp"
#include "workflow/stage_keys.hpp"
#include "workflow/store.hpp"

// The one way in which results come to be, or are taken from where they are.
namespace arenite::workflow {

/// What `read` gives; nothing, and a notice, if its file is damaged.
template <class Read>
auto unless_damaged(const std::filesystem::path& file, const RunOptions& options, const char* instead, Read read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const io::DamagedFile&) {
    options.notice(fmt::format("{}: is empty, cut short or changed; {}", file.string(), instead));
    return std::nullopt;
  }
}

/// A stage that is computed: its lock, if there is a store, and what it has cost so far.
class Claim {
 public:
  Claim(const RunOptions& options, const PlannedStage& stage) : options_(options), stage_(stage), began_(std::clock()) {}
  /// Waits until the stage is in the folder (true) or to be computed here (false); `stopped` says that neither came.
  bool taken_from_store(const std::filesystem::path& file);
  bool stopped = false;
  std::filesystem::path checkpoint(const std::filesystem::path& without_store) const;
  void computed(const std::filesystem::path& file) const;  ///< to be called when the stage's file is written
  void interrupted() const;
  void drop_stored() const;  ///< what the store holds of it is of no use

 private:
  bool fetch(const std::filesystem::path& file) const;
  double seconds() const { return static_cast<double>(std::clock() - began_) / CLOCKS_PER_SEC; }
  const RunOptions& options_;
  const PlannedStage& stage_;
  std::clock_t began_;
  std::optional<io::FileLock> lock_;
};

/// A stage: what it is called, where its result lies, and how that is made, written and read. A new kind of stage is one such record.
template <class Result> struct StageRecord {
  PlannedStage key;
  std::filesystem::path file;
  std::function<std::optional<Result>(const std::filesystem::path& checkpoint)> make;  ///< nothing if it was stopped
  void (*write)(const std::filesystem::path&, const Result&);
  Result (*read)(const std::filesystem::path&);
  const char* again = "this stage is computed again";  ///< what is said to follow where a file is damaged
};

/// Carries out a stage: its result comes from the run's folder, or from the store, or is made, written and read, so that what follows
/// sees the same numbers either way. Of those who want it at once one makes it. `reused` says that it was there; nothing if it was stopped.
template <class Result> std::optional<Result> carry_out(const StageRecord<Result>& stage, const RunOptions& options, bool& reused) {
  const auto look = [&]() -> std::optional<Result> {
    if (!std::filesystem::exists(stage.file)) return std::nullopt;
    auto found = unless_damaged(stage.file, options, stage.again, [&] { return stage.read(stage.file); });
    if (found && !stage.key.names(found->provenance.input_hash)) found.reset();  // names hold a part of the hash only
    return found;
  };
  const auto keep_in_store = [&] {
    if (options.store && !options.store->has(stage.key.hash)) options.store->put(stage.key.hash, stage.file);
  };
  Claim claim(options, stage.key);
  reused = true;
  if (auto here = look()) {
    keep_in_store();
    return here;
  }
  while (claim.taken_from_store(stage.file)) {
    if (auto fetched = look()) {
      keep_in_store();
      options.store->note_reused(stage.key);
      return fetched;
    }
    claim.drop_stored();
  }
  reused = false;
  if (claim.stopped) return std::nullopt;
  const auto made = stage.make(claim.checkpoint(stage.file.parent_path() / "run.checkpoint"));
  if (!made) {
    claim.interrupted();
    return std::nullopt;
  }
  make_folder(stage.file.parent_path());
  stage.write(stage.file, *made);
  claim.computed(stage.file);
  return stage.read(stage.file);
}

/// When a stage that takes long is kept on its way, so that it goes on there when it was killed: every `checkpoint_seconds`, and when it is asked to stop.
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

/// Shows how far a load has come, by its iterations and residual, and stops it where that is asked for.
peridynamics::Watch watch_of(Progress& progress, const RunOptions& options);

/// Where a killed test stood by its file, and how this one is kept there.
FailureCheckpoint failure_checkpoint(const std::filesystem::path& file, const std::string& key, const RunOptions& options);

/// `s` counts the stages of the plan.
Provenance provenance_of(const recipe::Recipe& recipe, std::size_t s, const PlannedStage& stage, const std::string& kernel);

}  // namespace arenite::workflow
