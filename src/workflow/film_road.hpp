#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "model/film_result.hpp"
#include "recipe/film_recipe.hpp"
#include "workflow/run.hpp"

namespace arenite::study {

struct FilmRunOptions {
  std::filesystem::path out;        ///< folder of the results
  int threads = 1;
  std::function<void(const Progress&)> progress = [](const Progress&) {};
  std::function<void(const std::string&)> notice = [](const std::string&) {};
  std::function<bool()> asked_to_stop = [] { return false; };
};

struct FilmOutcome {
  bool interrupted = false;
  std::filesystem::path file;
  FilmResult result;
  std::vector<StageResult> twin;    ///< stages of the simulation beside the film
};

/// A film's grains and the forces that were inferred, as a stage of one state, which pages and files take like simulated ones.
StageResult measured_stage(const FilmResult& film);

/// The whole road from a film to stresses of grains, contact forces and the simulation beside it; the result is one file
/// in `options.out`, named by the hash of all that it depends on. Throws InputError for what the recipe and the film do
/// not allow.
FilmOutcome run_film(const std::filesystem::path& film, const FilmRecipe& recipe, const FilmRunOptions& options);

}  // namespace arenite::study
