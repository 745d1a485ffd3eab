#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "grains/lammps/deck.hpp"
#include "workflow/lammps/engine_options.hpp"

namespace arenite::workflow {

/// A folder in which LAMMPS carries a sample: its deck, and job.sh, which starts it or goes on from its newest restart
/// file, on this machine or by `sbatch`.
class LammpsJob {
 public:
  /// Writes the files; what was there of another deck is removed, of the same one kept.
  LammpsJob(std::filesystem::path folder, const lammps::Deck& deck, const std::string& name,
            const EngineOptions& options);

  bool has_ended() const;
  /// Whether the programs of its command are there.
  bool can_start() const;
  /// Runs it to its end; false if it was asked to stop. `tell` gets the step it has come to. Throws CannotGoOn where
  /// LAMMPS fails, with what it says.
  bool run(const std::function<bool()>& asked_to_stop, const std::function<void(std::int64_t)>& tell) const;
  /// "LAMMPS (29 Sep 2021 - Update 2)", by its log.
  std::string version() const;
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::int64_t step_of_log() const;
  std::string what_went_wrong() const;
  std::filesystem::path folder_;
  std::string line_;
};

}  // namespace arenite::workflow
