#pragma once
#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "campaign/study_folder.hpp"
#include "core/parameters.hpp"
#include "core/thread_count.hpp"
#include "model/film_result.hpp"
#include "workflow/checkpoints.hpp"
#include "workflow/run.hpp"

namespace arenite::campaign {

/// Where a study, or this process's shard of it, stands.
struct StudyProgress {
  std::size_t runs = 0, done = 0, not_done = 0, running = 0;  ///< not_done: failed or without equilibrium
  double seconds_left =
      std::numeric_limits<double>::quiet_NaN();  ///< by what stages of the same name cost; nan: not known yet
};

/// Runs at once, one process each: unless given, as many as the machine has cores for.
struct Jobs {
  std::optional<std::int64_t> jobs;
  std::size_t at_once() const;
};
void declare(ParameterVisitor& visitor, Jobs& of);

struct StudyOptions {
  std::size_t jobs = Jobs{}.at_once();
  int threads = Threads{}.threads;    ///< in each of them
  std::size_t shard = 0, shards = 1;  ///< this process does one of `shards` equal parts of the runs
  /// Which runs are done again where they have failed or found no equilibrium.
  std::function<bool(const StudyRun&)> repeats = [](const StudyRun&) { return false; };
  bool keep_fields = true;  ///< false: field files go when their numbers are kept
  double checkpoint_seconds = workflow::Checkpoints{}.every;
  std::function<Numbers(const workflow::RunOutcome&)> numbers = [](const workflow::RunOutcome&) {
    return Numbers::tree();
  };
  std::function<Numbers(const FilmResult&)> film_numbers = [](const FilmResult& film) { return film.numbers; };
  std::function<void(const StudyProgress&)> progress = [](const StudyProgress&) {};
  std::function<void(const std::string&)> notice = [](const std::string&) {};
  std::function<bool()> asked_to_stop = [] { return false; };  ///< true: checkpoint and leave; asked in every process
};

struct StudyOutcome {
  std::size_t done = 0, not_done = 0, left = 0;  ///< of this shard's runs
  bool interrupted = false;
};

/// Runs a study, each run in a process of its own; what was done before is not done again. No run's failure ends the
/// others: its reason is in the journal and in its status file. Several processes, on several machines that share the
/// disk, may work on one study at once.
[[nodiscard]] StudyOutcome run_study(const Study& study, const StudyFolder& folder, const StudyOptions& options);

/// The runs of one shard, by their places in the study: an equal part, runs of one packing side by side. Of runs with
/// the same name only the first is in any.
std::vector<std::size_t> shard_of(const Study& study, std::size_t shard, std::size_t shards);

/// The CPU seconds of what is not in the store, by what stages of the same name cost; nan if one never ran.
double seconds_of_missing(const Study& study, const std::vector<std::size_t>& runs, const StudyFolder& folder);

}  // namespace arenite::campaign
