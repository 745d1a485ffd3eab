#pragma once
#include <chrono>
#include <filesystem>

#include "grains/dem/run_stage.hpp"
#include "workflow/grain_stage.hpp"

namespace arenite::workflow {

/// The name of the file in a run's folder that holds its stage under way.
inline constexpr const char* state_of_now = "run.now";

/// Keeps a stage under way as a file for whoever watches: its history so far and its state of now, every few seconds
/// and at most for a hundredth of the time. The file goes with this. A disk that is full stops no run.
template <int D> class StateOfNow {
 public:
  /// Nowhere if `folder` is empty.
  StateOfNow(const GrainStageIn<D>& stage, std::filesystem::path folder);
  ~StateOfNow();
  StateOfNow(const StateOfNow&) = delete;
  StateOfNow& operator=(const StateOfNow&) = delete;
  void show(const dem::EngineIn<D>& engine, const dem::StageRunIn<D>& run);

 private:
  using Clock = std::chrono::steady_clock;
  const GrainStageIn<D>& stage_;
  std::filesystem::path file_;
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
};

}  // namespace arenite::workflow
