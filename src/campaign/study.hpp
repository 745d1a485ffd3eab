#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "recipe/document.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"
#include "workflow/stage_keys.hpp"

namespace arenite::campaign {

/// One run of a study, of a simulation or of a film's measurement.
struct StudyRun {
  std::string name;  ///< hash of all that its results depend on, 16 digits
  std::vector<std::pair<std::string, std::string>>
      values;                                  ///< swept keys and their values as TOML, in the order of the sweep
  std::vector<workflow::PlannedStage> stages;  ///< packing first; of a measurement the film alone
};

/// A recipe with [sweep] and the runs that it becomes, no two of which have one name.
struct Study {
  std::string file, title;
  bool of_films = false;               ///< its recipe is that of a film, and its runs measure films
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

/// What one run says, checked and in SI; of a study of films the second.
recipe::Recipe recipe_of(const Study& study, const StudyRun& run);
recipe::FilmRecipe film_recipe_of(const Study& study, const StudyRun& run);

/// "cement.width = 0.1, seed = 2".
std::string describe(const StudyRun& run);

}  // namespace arenite::campaign
