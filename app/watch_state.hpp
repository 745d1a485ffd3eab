#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "run_status.hpp"
#include "statistics/numbers.hpp"
#include "statistics/numbers_text.hpp"

namespace arenite::app {

/// The status page, which asks for `state` beside it every second.
std::string watch_page();

/// What the page shows of a run's folder. Files are read once, and the checkpoint when it is new and not large. For one
/// thread at a time.
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
  struct Row {
    double time = 0;
    std::vector<double> values;  ///< in the order of `curve_names`; NaN where a side has no wall
  };
  struct Stage {
    std::string name, outcome;
    std::vector<Row> rows;
  };
  static std::vector<Row> rows_of(const History& history);
  std::vector<std::filesystem::path> files() const;
  void read_stages();
  void read_checkpoint(const RunStatus& status);
  void add_now(const RunStatus& status);
  Numbers curves() const;

  std::filesystem::path folder_;
  std::map<std::string, Stage> stages_;  ///< by file
  std::vector<Row> checkpoint_, now_;    ///< of the stage under way: as kept, and as heard since
  std::filesystem::file_time_type checkpoint_time_{};
  std::string key_;  ///< of the stage under way
  std::string page_;
  std::vector<std::filesystem::path> page_files_;
  std::chrono::steady_clock::time_point page_made_{};
};

}  // namespace arenite::app
