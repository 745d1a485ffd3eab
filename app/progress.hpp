#pragma once
#include <chrono>
#include <functional>
#include <string>

#include "campaign/run_study.hpp"
#include "workflow/run.hpp"

namespace arenite::app {

/// From now on SIGTERM and SIGINT ask for an orderly end.
void watch_for_signals();
bool stop_requested();
/// As those signals do.
void request_stop();

/// "1.2 s", "12 s", "5 min", "3.2 h".
std::string duration_text(double seconds);

/// A line on stderr, so that stdout stays clean: on a terminal it is rewritten, elsewhere the next one follows.
class StatusLine {
 public:
  explicit StatusLine(bool quiet);
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;
  ~StatusLine() { end(); }
  /// A line of its own, shown even if the progress is not.
  void notice(const std::string& sentence);

 protected:
  /// Whether nothing was shown for so long: on a terminal `pause`, elsewhere ten seconds.
  bool is_time(std::chrono::milliseconds pause) const;
  void write(const std::string& line);
  /// What is written next begins a line of its own.
  void end();
  bool quiet_;

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_, open_ = false;
  Clock::time_point last_shown_;
};

/// How long a stage has been going on, and how long it will, from the share that it has gained since it was first seen.
class StageClock {
 public:
  /// True where another stage than the last one was seen.
  bool see(const workflow::Progress& progress);
  double seconds() const;
  double seconds_left(double share) const;  ///< NaN where too little is known

 private:
  std::size_t stage_ = static_cast<std::size_t>(-1);
  double share_at_start_ = 0;
  std::chrono::steady_clock::time_point began_;
};

/// Shows where a run stands: on a terminal with a bar and the time left; elsewhere a plain line when a stage begins or
/// ends and at most one every ten seconds.
class ProgressLine : public StatusLine {
 public:
  using StatusLine::StatusLine;
  void show(const workflow::Progress& progress);

 private:
  std::string text(const workflow::Progress& progress) const;
  StageClock clock_;
};

/// The same for a study at work.
class StudyLine : public StatusLine {
 public:
  using StatusLine::StatusLine;
  void show(const campaign::StudyProgress& progress);

 private:
  std::string last_;
};

/// For work that reads a film and tells only its share: shows it, and false when the user asks to stop. The line must
/// outlive it.
std::function<bool(double share)> frames_progress(ProgressLine& line);

}  // namespace arenite::app
