#include "campaign/run_study.hpp"

#include <fmt/core.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>
#include <unordered_map>
#include <unordered_set>

#include "campaign/run_in_study.hpp"
#include "core/mapped.hpp"
#include "io/disk/file.hpp"
#include "workflow/result_folder.hpp"
#include "workflow/store.hpp"

namespace arenite::campaign {

std::vector<std::size_t> shard_of(const Study& study, std::size_t shard, std::size_t shards) {
  std::unordered_map<std::string, std::size_t> group_of;  // by packing
  std::vector<std::vector<std::size_t>> groups;
  std::unordered_set<std::string> seen;
  for (std::size_t r = 0; r < study.runs.size(); ++r) {
    if (!seen.insert(study.runs[r].name).second) continue;
    const auto [at, is_new] = group_of.emplace(study.runs[r].stages.front().hash, groups.size());
    if (is_new) groups.emplace_back();
    groups[at->second].push_back(r);
  }
  std::vector<std::size_t> part;
  std::size_t place = 0;
  for (const auto& group : groups)
    for (const std::size_t run : group)
      if (place++ * shards / seen.size() == shard) part.push_back(run);
  return part;
}

double seconds_of_missing(const Study& study, const std::vector<std::size_t>& runs, const StudyFolder& folder) {
  const workflow::StoreAccount account = workflow::read_account(folder.store);
  std::unordered_set<std::string> counted;
  std::error_code error;
  double seconds = 0;
  for (const std::size_t run : runs)
    for (const workflow::PlannedStage& stage : study.runs[run].stages) {
      if (!counted.insert(stage.hash).second ||
          std::filesystem::exists(workflow::stored_file(folder.store, stage.hash), error))
        continue;
      const auto mean = account.by_name.find(stage.name);
      seconds += mean == account.by_name.end() ? std::numeric_limits<double>::quiet_NaN()
                                               : mean->second.sum / static_cast<double>(mean->second.count);
    }
  return seconds;
}

namespace {

using Clock = std::chrono::steady_clock;
using Kind = RunState::Kind;

constexpr const char* elsewhere = "elsewhere";

/// A run at work; `stage` is the first that it has to compute.
struct Job {
  std::size_t run = 0;
  std::string stage;
  std::unique_ptr<Worker> worker;
};

class Scheduler {
 public:
  Scheduler(const Study& study, const StudyFolder& folder, const StudyOptions& options)
      : study_(study),
        folder_(folder),
        options_(options),
        store_(folder.store, options.notice),
        journal_(folder.journal(), options.notice),
        next_(study.runs.size(), 0) {
    workflow::make_folder(folder.out / "locks");
    for (const StudyRun& run : study.runs)
      for (const workflow::PlannedStage& stage : run.stages)
        if (stage.field && !options.keep_fields) field_users_[stage.hash].push_back(run.name);
    for (const std::size_t run : shard_of(study, options.shard, options.shards)) {
      const auto state = read_status(folder, study.runs[run].name);
      if (!state || is_wanted(study.runs[run], *state, options)) pending_.push_back(run);
      else settle(run, state->kind);
    }
    total_ = pending_.size() + progress_.done + progress_.not_done;
  }

  StudyOutcome work() {
    show(true);
    while (!pending_.empty() || !jobs_.empty()) {
      if (options_.asked_to_stop() && !stopping_) stop();
      if (!stopping_) fill();
      if (jobs_.empty() && stopping_) break;
      listen();
      show(false);
    }
    show(true);
    return {progress_.done, progress_.not_done, total_ - progress_.done - progress_.not_done,
            stopping_ && total_ > progress_.done + progress_.not_done};
  }

 private:
  void fill() {
    while (jobs_.size() < options_.jobs) {
      const auto chosen = choose();
      if (!chosen) return;
      const StudyRun& run = study_.runs[*chosen];
      jobs_.push_back({*chosen, first_missing(*chosen), std::make_unique<Worker>([&] {
                         const auto state = run_in_study(study_, run, folder_, store_, journal_, options_);
                         return std::string(state ? word_for(state->kind) : elsewhere);
                       })});
    }
  }

  /// The first run that would not have to wait for a stage which somebody computes now; taken out of the pending ones.
  std::optional<std::size_t> choose() {
    std::unordered_map<std::string, bool> busy;
    for (const Job& job : jobs_) busy[job.stage] = true;
    for (auto at = pending_.begin(); at != pending_.end(); ++at) {
      const std::string& stage = first_missing(*at);
      auto known = busy.find(stage);
      if (known == busy.end()) known = busy.emplace(stage, !stage.empty() && store_.is_busy(stage)).first;
      if (known->second && !stage.empty()) continue;
      if (io::FileLock::is_held(folder_.lock(study_.runs[*at].name))) continue;
      const std::size_t run = *at;
      pending_.erase(at);
      return run;
    }
    return std::nullopt;
  }

  /// Hash of the first stage of a run that is not in the store; empty if all are there.
  const std::string& first_missing(std::size_t run) {
    static const std::string none;
    const auto& stages = study_.runs[run].stages;
    while (next_[run] < stages.size() && store_.has(stages[next_[run]].hash)) ++next_[run];
    return next_[run] < stages.size() ? stages[next_[run]].hash : none;
  }

  void listen() {
    auto ears = mapped(jobs_, [](const Job& job) { return pollfd{job.worker->descriptor(), POLLIN, 0}; });
    ::poll(ears.data(), ears.size(), 100);
    for (std::size_t j = jobs_.size(); j-- > 0;) {
      if (ears[j].revents == 0) continue;
      const auto end = jobs_[j].worker->end();
      if (!end) continue;
      const std::size_t run = jobs_[j].run;
      jobs_.erase(jobs_.begin() + static_cast<std::ptrdiff_t>(j));
      ended(run, *end);
    }
  }

  void ended(std::size_t run, const Worker::End& end) {
    for (const Kind kind : {Kind::done, Kind::unfinished, Kind::failed})
      if (end.word == word_for(kind)) return settle(run, kind);
    if (end.word == elsewhere || end.word == word_for(Kind::waiting) || stopping_) {
      pending_.push_back(run);
      return;
    }
    const RunState state{
        Kind::failed, 0,
        end.signal != 0
            ? fmt::format("its process was ended by signal {} ({}); perhaps it ran out of memory", end.signal,
                          ::strsignal(end.signal))
            : fmt::format("its process ended with status {} without a message; perhaps the disk is full", end.status)};
    workflow::make_folder(folder_.run(study_.runs[run].name));
    write_status(folder_, study_.runs[run].name, state);
    note_state(journal_, study_.runs[run].name, state);
    settle(run, state.kind);
  }

  void settle(std::size_t run, Kind kind) {
    ++(kind == Kind::done ? progress_.done : progress_.not_done);
    if (!options_.keep_fields) drop_fields(study_.runs[run]);
  }

  /// Takes the field files of a run (cemented samples and loads), whose numbers are kept, away; those of the store when
  /// all runs that share them are settled.
  void drop_fields(const StudyRun& run) const {
    const auto is_settled = [&](const std::string& name) {
      const auto status = read_status(folder_, name);
      return status && status->settled();
    };
    for (const workflow::PlannedStage& stage : run.stages) {
      if (!stage.field) continue;
      std::error_code error;
      std::filesystem::remove(folder_.run(run.name) / stage.file, error);
      if (std::ranges::all_of(field_users_.at(stage.hash), is_settled)) store_.drop(stage.hash);
    }
  }

  void stop() {
    stopping_ = true;
    for (const Job& job : jobs_) job.worker->ask_to_stop();
  }

  void show(bool now) {
    progress_.runs = total_;
    progress_.running = jobs_.size();
    // Costs are summed over all that is left, which takes a while in a large study.
    if (now || Clock::now() >= next_estimate_) {
      const auto began = Clock::now();
      auto left = pending_;
      for (const Job& job : jobs_) left.push_back(job.run);
      progress_.seconds_left = seconds_of_missing(study_, left, folder_) /
                               static_cast<double>(options_.jobs * static_cast<std::size_t>(options_.threads));
      next_estimate_ = Clock::now() + std::max<Clock::duration>(std::chrono::seconds(1), 50 * (Clock::now() - began));
    }
    options_.progress(progress_);
  }

  const Study& study_;
  const StudyFolder& folder_;
  const StudyOptions& options_;
  const workflow::Store store_;
  const io::AppendLog journal_;
  std::unordered_map<std::string, std::vector<std::string>>
      field_users_;                          ///< names of runs, by hash of the stage; of fields that are not kept
  std::vector<std::size_t> pending_, next_;  ///< next_: first stage of each run that may be missing
  std::vector<Job> jobs_;
  StudyProgress progress_;
  std::size_t total_ = 0;
  bool stopping_ = false;
  Clock::time_point next_estimate_{};
};

}  // namespace

std::size_t Jobs::at_once() const {
  return jobs ? static_cast<std::size_t>(*jobs) : std::max(1u, std::thread::hardware_concurrency());
}

void declare(ParameterVisitor& v, Jobs& of) {
  v.integer({"jobs", "Concurrent runs, each in its own process; unless given, as many as there are cores."}, of.jobs,
            {1, 4096});
}

StudyOutcome run_study(const Study& study, const StudyFolder& folder, const StudyOptions& options) {
  for (const std::string& sentence : study.notices) options.notice(sentence);
  return Scheduler(study, folder, options).work();
}

}  // namespace arenite::campaign
