#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "campaign/study.hpp"
#include "io/disk/store_file.hpp"
#include "statistics/numbers.hpp"

namespace arenite::campaign {

/// Where a run of a study stands.
struct RunState {
  enum class Kind { waiting, running, done, unfinished, failed };
  Kind kind = Kind::waiting;
  double seconds = 0;  ///< of CPU in its last attempt
  std::string reason;  ///< one sentence: of a run without equilibrium, or that failed
  bool settled() const { return kind == Kind::done || kind == Kind::unfinished || kind == Kind::failed; }
};
const char* word_for(RunState::Kind kind);

/// A study on disk: runs.tsv (the runs), runs/NAME/ (stage files, recipe.toml, numbers.hdf5, the same for people as
/// numbers.json, and status of each), store/ (stages that runs share) unless that lies elsewhere, journal/ (what
/// happened when), locks/.
struct StudyFolder {
  std::filesystem::path out, store;
  explicit StudyFolder(std::filesystem::path folder, std::filesystem::path shared = {});
  std::filesystem::path run(const std::string& name) const { return out / "runs" / name; }
  std::filesystem::path status(const std::string& name) const { return run(name) / "status"; }
  std::filesystem::path journal() const { return out / "journal"; }
  std::filesystem::path lock(const std::string& name) const { return out / "locks" / name; }
};

/// How each run stands by the journal, by name; runs that never began are not there. A run that its process left
/// without a word counts as waiting.
using RunStates = std::unordered_map<std::string, RunState>;
RunStates read_states(const StudyFolder& folder);

// The journal's lines.
void note_state(const io::AppendLog& journal, const std::string& run, const RunState& state);
/// A run's own file of how it ended; the last that is written of it.
void write_status(const StudyFolder& folder, const std::string& run, const RunState& state);
std::optional<RunState> read_status(const StudyFolder& folder, const std::string& run);

/// Keeps the numbers of a run in its folder, and what is kept there; not known if there is nothing.
void keep_numbers(const std::filesystem::path& run, const Numbers& numbers);
Numbers numbers_of(const std::filesystem::path& run);

/// What a run gave: for those who read a study's results.
struct RunResult {
  RunState state;
  std::filesystem::path folder;
  std::vector<std::filesystem::path> stages;  ///< files with a StageResult (io::read_stage), packing first; of a
                                              ///< measurement that with the FilmResult
  std::vector<std::filesystem::path>
      fields;       ///< files with a FieldResult (io::read_field), cemented sample first; empty where they were dropped
  Numbers numbers;  ///< as `show --json` gives them; not known if the run has not ended
};
RunResult result_of(const StudyFolder& folder, const StudyRun& run);

/// Adds a notice if there are runs in the study's folder that version 0.1 did, which are not taken up.
void note_runs_of_version_0_1(const std::filesystem::path& folder, Study& study);

void write_runs(const std::filesystem::path& file, const Study& study);
/// False if there is none, or one of other inputs.
bool read_runs(const std::filesystem::path& file, Study& study);

}  // namespace arenite::campaign
