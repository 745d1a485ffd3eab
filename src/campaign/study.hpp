#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "recipe/document.hpp"
#include "recipe/recipe.hpp"
#include "workflow/stage_keys.hpp"

namespace arenite::campaign {

/// One key of a recipe, dotted as in --set, with a value for it; the value keeps the place where it was written.
struct Assignment {
  std::string key;
  recipe::Node value;
};
using Point = std::vector<Assignment>;

/// What [sweep] asks for: every combination of a point of each axis. A key of [sweep.grid] is an axis of its own;
/// [[sweep.list]], sweep.table and [sweep.latin_hypercube] are one axis each. The last axis varies fastest.
struct Sweep {
  enum class Seeds { consecutive, hashed };
  std::vector<std::vector<Point>> axes;
  std::int64_t replicates = 0;  ///< runs of each combination with seeds of their own; 0: the recipe's seed
  Seeds seeds = Seeds::consecutive;
  std::vector<std::string> files;  ///< that it was read from, beside the recipe

  std::size_t combinations() const;
  Point combination(std::size_t index) const;
  std::vector<std::string> keys() const;  ///< in the order of the axes, each once
};

/// Reads the section [sweep]. `seed` is the recipe's own: it seeds the Latin hypercube. Problems are collected in
/// `reading`.
Sweep read_sweep(const recipe::Node& section, recipe::Reading& reading, std::uint64_t seed);

/// More runs than anybody means to ask for.
inline constexpr std::size_t most_runs = 1'000'000;

// The parts of read_sweep, one a form.
/// Dotted keys of a table and of the tables in it; `is_leaf` says which tables are values by themselves.
std::vector<Assignment> flattened(const recipe::Node& table, const std::function<bool(const recipe::Node&)>& is_leaf);
std::vector<Point> latin_hypercube_points(const recipe::Node& section, recipe::Reading& reading, std::uint64_t seed);

/// One run of a study.
struct StudyRun {
  std::string name;  ///< hash of all that its results depend on, 16 digits
  std::vector<std::pair<std::string, std::string>>
      values;                                  ///< swept keys and their values as TOML, in the order of the sweep
  std::vector<workflow::PlannedStage> stages;  ///< packing first
};

/// A recipe with [sweep] and the runs that it becomes. Runs that differ in nothing that their results depend on have
/// one name.
struct Study {
  std::string file, title;
  std::vector<std::string> overrides;  ///< as given with --set
  std::vector<std::string> notices;    ///< what the reader of the recipe found worth a word
  std::vector<std::string> keys;       ///< that are swept, in order; "seed" last where there are replicates
  std::vector<StudyRun> runs;
  std::vector<std::pair<std::string, std::string>> inputs;  ///< files that it was read from, and their hashes
  recipe::Node tree;                                        ///< of the recipe without [sweep]
};

/// Reads a recipe with [sweep] and all of its runs; with a folder, which must exist, runs are taken from its runs.tsv
/// where that was written for the same inputs, and written there else. Throws InputError with every problem of every
/// run, each once, with its place and, where not all runs have it, the values of the first run that does.
Study read_study(const std::string& file, const std::vector<std::string>& overrides = {},
                 const std::filesystem::path& folder = {});

/// Adds a notice if there are runs in the study's folder that version 0.1 did, which are not taken up.
void note_runs_of_version_0_1(const std::filesystem::path& folder, Study& study);

/// What one run says, checked and in SI.
recipe::Recipe recipe_of(const Study& study, const StudyRun& run);

/// "cement.width = 0.1, seed = 2".
std::string describe(const StudyRun& run);

// The parts of the table of runs.
void write_runs(const std::filesystem::path& file, const Study& study);
/// False if there is none, or one of other inputs.
bool read_runs(const std::filesystem::path& file, Study& study);

}  // namespace arenite::campaign
