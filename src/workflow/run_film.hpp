#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "model/film_result.hpp"
#include "recipe/film_recipe.hpp"
#include "statistics/numbers.hpp"
#include "workflow/run.hpp"

namespace arenite::workflow {

struct FilmRunOptions : RunOptions {
  int threads = 1;
};

struct FilmOutcome {
  bool interrupted = false;
  std::filesystem::path file;
  FilmResult result;
  std::vector<StageResult> simulation;  ///< stages of the companion simulation
};

/// A film's grains and the forces that were inferred, as a stage of one state, which pages and files take like simulated ones.
StageResult measured_stage(const FilmResult& film);

/// The whole workflow from a film to stresses of grains, contact forces and the companion simulation; the result is one file in `options.out`, named by
/// the hash of all that it depends on. Throws InputError for what the recipe and the film do not allow.
FilmOutcome run_film(const std::filesystem::path& film, const recipe::FilmRecipe& recipe, const FilmRunOptions& options);

/// What came of the companion simulation of a film.
struct CompanionRun {
  FilmSimulation stresses;  ///< empty if it was stopped or found no equilibrium
  Packing loaded;           ///< at the largest load; without grains as `stresses` is empty
  std::vector<StageResult> stages;
  std::string outcome;
  bool converged = true, interrupted = false;
};

/// Stress of every grain as its normal forces make it, -sum fn/(2 pi R L), Pa, tension positive: the mean over the disk whose
/// rim carries them, which is what pixels show. (A stress by branch vectors has arms shortened by the overlaps.)
std::vector<double> stress_of_disks(const Packing& packing);

/// Simulates the grains that were found in a film, from their places at the smallest load, by the recipe that [simulation] names:
/// its packing is replaced, its container, laws and stages are kept. Results go to `options.out`, as those of `run`. Throws
/// InputError for a recipe without the stages that [simulation] names or without the grains' materials.
CompanionRun run_companion(const recipe::FilmRecipe& recipe, const FilmResult& film, const RunOptions& options);

/// Statistics of what a film gave, as `arenite film --json` prints them: frequency, noise, grains by material, motion,
/// sigma_norm (by the code that measures simulated packings), contact forces, contact orientations, and the comparison
/// with the companion simulation, of whose state at the largest load the contacts count.
Numbers film_numbers(const FilmResult& result, const Packing* simulation = nullptr);

/// How two stresses of the same grains agree: correlation, root mean square difference of sigma_norm (each over the mean of
/// its own), slope through the origin.
struct Agreement {
  std::size_t grains = 0;
  double correlation = 0, rms_sigma_norm = 0, slope = 0;
};
/// Grains where `counts` is 0 are left out.
Agreement agreement(const std::vector<double>& one, const std::vector<double>& other, const std::vector<std::uint8_t>& counts);

/// Directions of the contacts that a film shows and, where it is given, of those of its companion simulation: "film" and "simulation", each with "contacts",
/// "a_c", "theta_c_deg", "a_c_noise" and the numbers in "sectors" of 10 degrees, over the same window (without the border). Empty without contacts.
Numbers film_directions(const FilmResult& film, const Packing* simulation = nullptr);

}  // namespace arenite::workflow
