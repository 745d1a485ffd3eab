#pragma once
#include <sys/types.h>
#include <functional>
#include <optional>
#include <string>

#include "campaign/run_study.hpp"
#include "campaign/study_folder.hpp"
#include "workflow/run.hpp"
#include "workflow/store.hpp"

namespace arenite::campaign {

/// A process of its own that does one thing and says one word. It is asked to stop (SIGTERM) when this process dies.
class Worker {
 public:
  /// `work` gives the word; it must let no exception out.
  explicit Worker(const std::function<std::string()>& work);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker();

  int descriptor() const { return pipe_; }  ///< readable when there is something to hear
  void ask_to_stop() const;
  /// How it ended: its word, or, where it died without one, the signal or status that it died of.
  struct End {
    std::string word;
    int signal = 0, status = 0;
  };
  /// Nothing while it is at work.
  std::optional<End> end();

 private:
  pid_t process_ = -1;
  int pipe_ = -1;
  std::string heard_;
};

/// Whether a run that is in this state is to be done.
bool is_wanted(const StudyRun& run, const RunState& state, const StudyOptions& options);

/// Does one run of a study in this process, and writes its numbers, status and journal. Nothing if another process is
/// at it. No exception leaves it: what goes wrong is the run's state. `waiting` says that it was asked to stop.
std::optional<RunState> run_in_study(const Study& study, const StudyRun& run, const StudyFolder& folder,
                                     const workflow::Store& store, const io::AppendLog& journal,
                                     const StudyOptions& options);

}  // namespace arenite::campaign
