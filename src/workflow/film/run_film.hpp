#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/thread_count.hpp"
#include "model/film_result.hpp"
#include "recipe/film_recipe.hpp"
#include "workflow/run.hpp"

namespace arenite::workflow {

struct FilmRunOptions : RunOptions {
  int threads = Threads{}.threads;
};

struct FilmOutcome {
  bool interrupted = false;
  std::filesystem::path file;
  FilmResult result;
  RunOutcome simulation;  ///< the companion simulation; what was measured of the film is with what was of its stages
};

/// A film's grains and the forces that were inferred, as a stage of one state, which pages and files take like
/// simulated ones.
StageResult measured_stage(const FilmResult& film);

/// The whole workflow from a film to stresses of grains, contact forces and the companion simulation; the result is one
/// file in `options.out`, named by the hash of all that it depends on, and those of the companion simulation are in
/// `options.out`/simulation. Throws InputError for what the recipe and the film do not allow, and for a companion's
/// recipe without the stages that [simulation] names or without the grains' materials.
FilmOutcome run_film(const std::filesystem::path& film, const recipe::FilmRecipe& recipe,
                     const FilmRunOptions& options);

}  // namespace arenite::workflow
