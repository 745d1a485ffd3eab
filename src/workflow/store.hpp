#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "io/disk/file.hpp"
#include "io/disk/store_file.hpp"
#include "workflow/stage_keys.hpp"

namespace arenite::workflow {

/// Where a stage lies, or would lie, in a store.
std::filesystem::path stored_file(const std::filesystem::path& store, const std::string& hash);

/// Stages that runs share: a folder with one file a stage, named by its hash, put there whole or not at all by any
/// number of processes. Who computes a stage holds its lock meanwhile. What was computed and what was taken instead is
/// noted.
class Store {
 public:
  /// Makes the folder. Throws InputError if that cannot be. `notice` hears what is lost from the account.
  explicit Store(std::filesystem::path folder, std::function<void(const std::string&)> notice = {});

  /// The same stages for those that are made as a part of another, whose cost in the account has theirs.
  std::unique_ptr<const Store> for_parts() const;

  std::filesystem::path file(const std::string& hash) const;
  std::filesystem::path checkpoint(const std::string& hash) const;
  bool has(const std::string& hash) const;
  /// Whether somebody computes this stage now.
  bool is_busy(const std::string& hash) const;
  /// The right to compute a stage; nothing if somebody has it.
  std::optional<io::FileLock> try_claim(const std::string& hash) const;
  /// Puts the stored file to `to` (by a hard link where the disk allows one); false if there is none.
  bool fetch(const std::string& hash, const std::filesystem::path& to) const;
  void put(const std::string& hash, const std::filesystem::path& from) const;
  void drop(const std::string& hash) const;

  /// For the account; CPU seconds. What is begun was stopped before its end, and is to be gone on with.
  enum class Event { computed, begun, reused };
  void note(Event event, const PlannedStage& stage, double seconds = 0) const;

 private:
  explicit Store(const Store* of) : folder_(of->folder_) {}
  std::filesystem::path folder_;
  std::optional<io::AppendLog> account_;  ///< nothing for parts of stages
};

/// What the stages of a store cost, in CPU seconds, and what sharing them saved.
struct StoreAccount {
  struct Mean {
    double sum = 0;
    std::size_t count = 0;
  };
  std::map<std::string, double> cost;   ///< by hash
  std::map<std::string, Mean> by_name;  ///< of stages of that name
  std::size_t computed = 0, reused = 0;
  double seconds_computed = 0, seconds_saved = 0;
};
StoreAccount read_account(const std::filesystem::path& store);

}  // namespace arenite::workflow
