#pragma once
#include <chrono>
#include <filesystem>
#include <string>

#include "grains/dem/run_stage.hpp"
#include "io/results/results.hpp"
#include "workflow/field_stages.hpp"
#include "workflow/run.hpp"

// How a stage that takes long is shown and kept on its way, so that it goes on there when it was killed.
namespace arenite::workflow {

/// When it is kept: every `checkpoint_seconds`, and when it is asked to stop.
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

/// A stage of loading grains.
io::Checkpoint to_checkpoint(const dem::Engine& engine, const dem::StageRun& run, const std::string& key);
void restore_from(const io::Checkpoint& checkpoint, dem::Engine& engine, dem::StageRun& run);

/// Shows how far a load has come, by its iterations and residual, and stops it where that is asked for.
peridynamics::Watch watch_of(Progress& progress, const RunOptions& options);

/// Where a killed test stood by its file, and how this one is kept there.
FailureCheckpoint failure_checkpoint(const std::filesystem::path& file, const std::string& key, const RunOptions& options);

}  // namespace arenite::workflow
