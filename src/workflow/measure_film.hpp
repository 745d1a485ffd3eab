#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/film/film.hpp"
#include "model/film.hpp"
#include "model/film_result.hpp"
#include "recipe/film_recipe.hpp"
#include "thermal/thermography/calibration.hpp"
#include "thermal/thermography/correction.hpp"
#include "thermal/thermography/load_signal.hpp"
#include "workflow/run_film.hpp"

namespace arenite::workflow {

/// What is done to a film before it is looked at, as its recipe says.
struct FilmCorrection {
  thermography::Correction correction;
  std::vector<std::uint8_t> bad;         ///< 1 for pixels that are replaced
  thermography::GrainSurfaces surfaces;  ///< what is left to do where materials are known: their emissivities, if these differ
  bool kelvin = false;                   ///< what comes out are temperatures
  std::vector<std::string> notes;        ///< what a user should know: constant or saturated pixels
};

/// How the film and its references are to be read, where the recipe says it.
io::FilmChoice reading_of(const recipe::FilmRecipe& recipe);

/// Reads references and curve, and looks at the film's first frames for bad pixels. Throws InputError for references of another size
/// and films that do not hold what [temperature] says.
FilmCorrection make_correction(const recipe::FilmRecipe& recipe, FilmSource& film);

/// The load's cycle from the lock-in line of a .ptw film; nothing for films without. `notice` is called where the line shows no cycle near the
/// given frequency, or another one.
std::optional<thermography::LoadSignal> load_signal_of(const std::filesystem::path& path, const FilmInfo& film, double given,
                                                       const std::function<void(const std::string&)>& notice);

/// Proposes contacts between the grains of `result.packing` and infers their forces from its maps, or from the means of
/// grains, as the recipe's [forces] says. Contacts are proposed where grains touch at the largest or at the smallest load
/// (`result.grains`): one that opens on the way loses its force.
void infer_film_forces(const recipe::FilmRecipe& recipe, FilmResult& result);

/// Adds to the errors of the stresses what a blur of the lens that is known to `blur_error` only leaves; `wider` are the
/// stresses when rims are taken off with a blur larger by `step` (pixels).
void add_blur_error(PeakToPeak& change, const PeakToPeak& wider, double step, double blur_error);

/// Adds what noise does not explain, once the forces are known: the mean over a grain's centre differs from the mean that the
/// forces (held by the balance of all grains) put there, seen through the same lens and pixels. The median difference of
/// the grains of a material is the error of all of them that rim, motion and the camera's fixed pattern leave; a grain whose own
/// difference is larger than that is less sure. `shown` are the grains in the maps' pixels, `share` the part averaged.
void add_fit_error(FilmResult& result, const PictureGrains& shown, double share);

/// Measures a film: correction, lock-in, grains in the picture, their motion, stresses and contact forces, into `result`.
/// False if it was stopped. Throws InputError, without the film's name, for what the recipe and the film do not allow.
bool measure_film(const recipe::FilmRecipe& recipe, const FilmRunOptions& options, FilmSource& film, FilmResult& result);

}  // namespace arenite::workflow
