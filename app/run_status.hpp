#pragma once
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "io/disk/file.hpp"
#include "progress.hpp"
#include "statistics/numbers.hpp"
#include "workflow/run.hpp"

namespace arenite::app {

/// Where a run stood when it was last heard of: what `status.csv` in its folder says.
struct RunStatus {
  workflow::Progress progress;
  bool stopped = false;      ///< in an orderly way, with a checkpoint
  std::int64_t process = 0;  ///< for people: whether it lives is told by its lock alone
  std::string host;
  double began = 0, stage_began = 0, heard = 0;  ///< s since 1970
  double seconds_left = 0;                       ///< of the stage; NaN where not known
};

/// Nothing where the folder has no such file, or one that cannot be read.
std::optional<RunStatus> read_run_status(const std::filesystem::path& folder);

enum class Life { running, stopped, died, unknown };  ///< unknown: of another machine, and not heard of for a minute
Life life_of(const RunStatus& status, const std::filesystem::path& folder);

/// Asks the run in this folder to write its checkpoint and leave, by a file that it looks for; no process is signalled
/// by a number that stands in a file. False where none runs on this machine.
bool ask_to_stop(const std::filesystem::path& folder);

/// What is running, in lines for people; empty for a folder without a status.
std::string run_status_text(const std::filesystem::path& folder);
/// The same for programs.
Numbers run_status_numbers(const RunStatus& status);

/// Keeps `status.csv` of a run, at most every half second and by a thread of its own, so that the run never waits for
/// the disk. Nothing is written before the folder is there, or where it cannot be; a run that ends whole removes it,
/// one that is stopped leaves it. Meanwhile it holds a lock beside the file, by which others see that the run lives,
/// and calls `stop` where it is asked to leave.
class StatusFile {
 public:
  StatusFile(std::filesystem::path folder, std::function<void()> stop);
  ~StatusFile();
  StatusFile(const StatusFile&) = delete;
  StatusFile& operator=(const StatusFile&) = delete;
  void show(const workflow::Progress& progress);
  void finish();  ///< the file is removed

 private:
  void keep();
  bool write();
  bool has_lock();
  void see_whether_to_stop();
  std::filesystem::path folder_;
  std::function<void()> stop_;
  std::optional<io::FileLock> lock_;
  std::mutex mutex_;
  std::condition_variable wake_;
  RunStatus status_;
  StageClock clock_;
  bool changed_ = true, over_ = false;
  std::thread writer_;
};

}  // namespace arenite::app
