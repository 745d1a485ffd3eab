#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "grains/texture/texture.hpp"
#include "model/film_result.hpp"
#include "recipe/film_recipe.hpp"
#include "statistics/correlation.hpp"
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
  RunOutcome simulation;  ///< the companion simulation
};

/// A film's grains and the forces that were inferred, as a stage of one state, which pages and files take like simulated ones.
StageResult measured_stage(const FilmResult& film);

/// The whole workflow from a film to stresses of grains, contact forces and the companion simulation; the result is one file in `options.out`, named by
/// the hash of all that it depends on, and those of the companion simulation are in `options.out`/simulation. Throws InputError for what the recipe and the
/// film do not allow, and for a companion's recipe without the stages that [simulation] names or without the grains' materials.
FilmOutcome run_film(const std::filesystem::path& film, const recipe::FilmRecipe& recipe, const FilmRunOptions& options);

/// Stress of every grain as its normal forces make it, -sum fn/(2 pi R L), Pa, tension positive: the mean over the disk whose
/// rim carries them, which is what pixels show. (A stress by branch vectors has arms shortened by the overlaps.)
std::vector<double> stress_of_disks(const Packing& packing);

/// Texture of a film's grains and contacts, with the stresses that the film gives; without the REV study.
texture::Texture texture_of(const FilmResult& film);

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
Numbers film_orientations(const FilmResult& film, const Packing* simulation = nullptr);

/// Stress of the grains from one source, Pa, tension positive, over the mean of the grains that count.
struct GrainStresses {
  std::string source;                 ///< "film", "simulation_peak_to_peak", "simulation_state"
  std::vector<double> sigma_hyd;      ///< one a grain; NaN where it is not known in every source
  std::vector<double> sigma_norm;     ///< likewise
  double mean = statistics::unknown;  ///< that sigma_norm is over, Pa
  Numbers statistics;                 ///< "sigma_norm" as texture::numbers has it; {} where nothing can be measured
};

/// The stresses of a film and, where there is one, of its companion simulation, peak to peak and as the state at the largest load. All three are taken over the same grains: those whose stress is
/// known in each. Grains count as texture has them (without a border where that would leave none).
struct FilmStresses {
  std::vector<GrainStresses> sources;
  std::vector<std::uint8_t> considered;  ///< 1 for grains that count; empty without sources
};

FilmStresses film_stresses(const FilmResult& result, const texture::Options& options);

/// How the film (y) follows its companion simulation (x) over the grains that are known in both.
struct StressRelation {
  std::string set;  ///< "all", or a material
  statistics::Relation relation;
  double rms = statistics::unknown;       ///< root mean square of the difference, Pa
  double rms_norm = statistics::unknown;  ///< likewise of sigma_norm
};

/// "all" first, then by material where there are several; sets of less than three grains are left out.
std::vector<StressRelation> stress_relations(const Packing& packing, const GrainStresses& film, const GrainStresses& simulation);

struct RenderOptions {
  std::filesystem::path out;
  std::string format = "ptw";  ///< of the films
  bool blind = false;          ///< film.toml has no more than a laboratory knows: no blur, surroundings, phase or travel of the wall
  std::function<bool(double share)> progress = [](double) { return true; };  ///< false stops
};

/// Films two simulated states (or one, or a load of the cemented sample, from no load) with the recipe's [camera]. Writes the film, two films of black-body references,
/// an optical picture at the smallest load, and the recipe film.toml that `arenite film` takes; returns the files, none if it was
/// stopped. `result` is a run's folder or a file of it. Throws InputError for stages that are not there.
std::vector<std::filesystem::path> render_film(const recipe::FilmRecipe& recipe, const std::filesystem::path& result, const RenderOptions& options);

}  // namespace arenite::workflow
