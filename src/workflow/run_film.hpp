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

/// Stress of every grain as its normal forces make it, -sum fn/(2 pi R L), Pa, tension positive: the mean over the disk
/// whose rim carries them, which is what pixels show. (A stress by branch vectors has arms shortened by the overlaps.)
std::vector<double> stress_of_disks(const Packing& packing);

/// Texture of a film's grains and contacts, with the stresses that the film gives; `rev` says whether the REV study is
/// wanted, which takes longest.
texture::Texture texture_of(const FilmResult& film, bool rev = true);

/// Statistics of what a film gave, as `arenite film --json` prints them: frequency, noise, grains by material, motion,
/// sigma_norm (by the code that measures simulated packings), contact forces, contact orientations, stresses of grains
/// by source, and how they agree. `texture` is the film's (texture_of), `simulation` that of the companion simulation
/// at the largest load.
Numbers film_numbers(const FilmResult& result, const texture::Texture& texture,
                     const texture::Texture* simulation = nullptr);

/// Stress of the grains from one source, Pa, tension positive.
struct GrainStresses {
  std::string source;                 ///< "film", "simulation_peak_to_peak", "simulation_state"
  std::vector<double> sigma_hyd;      ///< one a grain; NaN where it is not known in every source
  std::vector<double> sigma_norm;     ///< over `mean`
  double mean = statistics::unknown;  ///< of the grains that count, Pa
};

/// The stresses of a film and, where there is one, of its companion simulation, peak to peak and as the state at the
/// largest load, over the same grains: those whose stress is known in each.
struct FilmStresses {
  std::vector<GrainStresses> sources;
  std::vector<std::uint8_t> considered;  ///< 1 for grains that count; empty without sources
};
/// Of these grains those count that `considered` has, as the film's texture says; all of them where it has fewer than
/// three.
FilmStresses film_stresses(const FilmResult& result, const std::vector<std::uint8_t>& considered);

/// How two stresses of the same grains agree.
struct Agreement {
  statistics::Relation relation;                ///< of the film (y) to the simulation (x)
  double rms = statistics::unknown;             ///< root mean square difference, Pa
  double rms_sigma_norm = statistics::unknown;  ///< likewise of each over its mean
};
/// Over grains that are known in both and where `counts` is 1; unknown for fewer than two.
Agreement agreement(const std::vector<double>& film, const std::vector<double>& simulation,
                    const std::vector<std::uint8_t>& counts);
/// As all results call them: count, correlation, slope, rms_Pa, rms_sigma_norm.
Numbers numbers(const Agreement& agreement);
/// How the film agrees with one source of the simulation: "all" first, then by material where there are several; sets
/// of fewer than three grains are left out.
Numbers agreement_of(const Packing& packing, const FilmStresses& stresses, const GrainStresses& simulation);

struct RenderOptions {
  std::filesystem::path out;
  std::string format = "ptw";  ///< of the films
  bool blind =
      false;  ///< film.toml has no more than a laboratory knows: no blur, surroundings, phase or travel of the wall
  std::function<bool(double share)> progress = [](double) { return true; };  ///< false stops
};

/// Films two simulated states (or one, or a load of the cemented sample, from no load) with the recipe's [camera].
/// Writes the film, two films of black-body references, an optical picture at the smallest load, and the recipe
/// film.toml that `arenite film` takes; returns the files, none if it was stopped. `result` is a run's folder or a file
/// of it. Throws InputError for stages that are not there.
std::vector<std::filesystem::path> render_film(const recipe::FilmRecipe& recipe, const std::filesystem::path& result,
                                               const RenderOptions& options);

}  // namespace arenite::workflow
