#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/packing.hpp"
#include "run_status.hpp"
#include "statistics/numbers.hpp"
#include "statistics/numbers_text.hpp"

namespace arenite::app {

/// The status page, which asks for `state` beside it every second (web/src/study/live.js).
std::string watch_page();

/// What the page shows of a run's folder. Files are read once, and that of the stage under way when it is new and not
/// large. For one thread at a time.
class WatchState {
 public:
  explicit WatchState(std::filesystem::path folder) : folder_(std::move(folder)) {}
  Numbers numbers();
  /// The full page of the stages that have ended, made anew at most every few seconds; empty while there is none.
  std::string page();
  bool stop() const;
  /// The run has come to its end, or was never seen to run.
  bool has_ended() const { return !read_run_status(folder_); }

 private:
  struct Stage {
    std::string name, outcome;
  };
  std::vector<std::filesystem::path> files() const;
  void read_stages();
  void read_now();

  std::filesystem::path folder_;
  std::map<std::string, Stage> stages_;  ///< by file
  std::optional<Packing> before_;        ///< of the last stage that has ended, to which strains refer
  Numbers figures_ = Numbers::list();    ///< of the stage under way
  std::filesystem::file_time_type now_written_{};
  std::int64_t at_ = 0;  ///< how often they have changed
  std::string page_;
  std::vector<std::filesystem::path> page_files_;
  std::chrono::steady_clock::time_point page_made_{};
};

}  // namespace arenite::app
