#pragma once
#include <fmt/format.h>

#include <ctime>
#include <filesystem>
#include <optional>
#include <string>

#include "io/sealed_file.hpp"
#include "workflow/run.hpp"
#include "workflow/stage_keys.hpp"
#include "workflow/store.hpp"

// What the parts of a run share.
namespace arenite::study {

/// What `read` gives; nothing, and a notice, if its file is damaged.
template <class Read>
auto unless_damaged(const std::filesystem::path& file, const RunOptions& options, const char* instead, Read read)
    -> std::optional<decltype(read())> {
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

 private:
  double seconds() const { return static_cast<double>(std::clock() - began_) / CLOCKS_PER_SEC; }
  const RunOptions& options_;
  const PlannedStage& stage_;
  std::clock_t began_;
  std::optional<io::FileLock> lock_;
};

/// The result in the run's folder, or from the store; nothing if it is to be computed under the claim, or was stopped.
template <class Read>
auto stored_or_claimed(const std::filesystem::path& file, const RunOptions& options, const PlannedStage& stage, Claim& claim, Read read)
    -> std::optional<decltype(read(file))> {
  const auto look = [&]() -> std::optional<decltype(read(file))> {
    if (!std::filesystem::exists(file)) return std::nullopt;
    auto found = unless_damaged(file, options, "this stage is computed again", [&] { return read(file); });
    if (found && found->provenance.input_hash != stage.hash) found.reset();  // names hold a part of the hash only
    return found;
  };
  if (auto here = look()) {
    if (options.store && !options.store->has(stage.hash)) options.store->put(stage.hash, file);
    return here;
  }
  while (claim.taken_from_store(file)) {
    if (auto fetched = look()) {
      options.store->note_reused(stage);
      return fetched;
    }
    options.store->drop(stage.hash);
  }
  return std::nullopt;
}

/// `s` counts the stages of the plan.
Provenance provenance_of(const Recipe& recipe, std::size_t s, const PlannedStage& stage, const std::string& kernel);

}  // namespace arenite::study
