#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "recipe/document.hpp"
#include "recipe/recipe.hpp"
#include "workflow/stage_keys.hpp"

namespace arenite::campaign {

/// One run of a study.
struct StudyRun {
  std::string name;                                         ///< hash of all that its results depend on, 16 digits
  std::vector<std::pair<std::string, std::string>> values;  ///< swept keys and their values as TOML, in the order of the sweep
  std::vector<workflow::PlannedStage> stages;               ///< packing first
  std::string former{};                                     ///< name of the same run by version 0.1; empty where it was read from runs.tsv
};

/// A recipe with [sweep] and the runs that it becomes. Runs that differ in nothing that their results depend on have one name.
struct Study {
  std::string file, title;
  std::vector<std::string> overrides;  ///< as given with --set
  std::vector<std::string> notices;    ///< what the reader of the recipe found worth a word
  std::vector<std::string> keys;       ///< that are swept, in order; "seed" last where there are replicates
  std::vector<StudyRun> runs;
  std::vector<std::pair<std::string, std::string>> inputs;  ///< files that it was read from, and their hashes
  recipe::Node tree;                                        ///< of the recipe without [sweep]
};

/// Reads a recipe with [sweep] and all of its runs. Throws InputError with every problem of every run, each once, with its
/// place and, where not all runs have it, the values of the first run that does.
Study read_study(const std::string& file, const std::vector<std::string>& overrides = {});

/// The same, but runs are taken from `folder`/runs.tsv where it was written for the same inputs; it is written there else. `folder` must exist.
Study read_study(const std::string& file, const std::vector<std::string>& overrides, const std::filesystem::path& folder);

/// Runs that version 0.1 did in the study's folder get their names of now, and so do their files.
void rename_former_runs(const std::filesystem::path& folder, const Study& study);

/// What one run says, checked and in SI.
recipe::Recipe recipe_of(const Study& study, const StudyRun& run);

/// "cement.width = 0.1, seed = 2".
std::string describe(const StudyRun& run);

// The parts of the table of runs.
void write_runs(const std::filesystem::path& file, const Study& study);
/// False if there is none, or one of other inputs.
bool read_runs(const std::filesystem::path& file, Study& study);

}  // namespace arenite::campaign
