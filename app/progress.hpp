#pragma once
#include <chrono>
#include <functional>
#include <string>

#include "workflow/run.hpp"

namespace arenite::app {

/// Shows where a run stands: on a terminal one line that is rewritten, with a bar and the time left; elsewhere a plain
/// line when a stage begins or ends and at most one every ten seconds. Writes to stderr, so that stdout stays clean.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  void show(const study::Progress& progress);
  /// A line of its own, shown even if the progress is not.
  void notice(const std::string& sentence);

 private:
  using Clock = std::chrono::steady_clock;
  void begin_stage(const study::Progress& progress);
  std::string text(const study::Progress& progress) const;
  bool quiet_, terminal_, open_ = false;
  std::size_t stage_ = static_cast<std::size_t>(-1);
  double share_at_start_ = 0;
  Clock::time_point stage_began_, last_shown_;
};

/// For work that reads a film and tells only its share: shows it, and false when the user asks to stop. The line must
/// outlive it.
std::function<bool(double share)> frames_progress(ProgressLine& line);

}  // namespace arenite::app
