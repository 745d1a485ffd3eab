#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "model/film_result.hpp"
#include "recipe/film_recipe.hpp"
#include "workflow/run.hpp"

namespace arenite::study {

/// What came of the simulation beside a film.
struct TwinRun {
  FilmTwin stresses;                ///< empty if it was stopped or did not come to rest
  Packing loaded;                   ///< at the largest load; without grains as `stresses` is empty
  std::vector<StageResult> stages;
  std::string outcome;
  bool converged = true, interrupted = false;
};

/// Stress of every grain as its normal forces make it, -sum fn/(2 pi R L), Pa, tension positive: the mean over the disk whose
/// rim carries them, which is what pixels show. (A stress by branch vectors has arms shortened by the overlaps.)
std::vector<double> stress_of_disks(const Packing& packing);

/// Simulates the grains that were found in a film, from their places at the smallest load, by the recipe that [twin] names:
/// its packing is replaced, its frame, laws and stages are kept. Results go to `options.out`, as those of `run`. Throws
/// InputError for a recipe without the stages that [twin] names or without the grains' materials.
TwinRun run_twin(const FilmRecipe& recipe, const FilmResult& film, const RunOptions& options);

}  // namespace arenite::study
