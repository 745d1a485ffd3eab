#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/film.hpp"
#include "model/film_result.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"
#include "thermal/thermography/frame_statistics.hpp"

namespace arenite::workflow {

/// Whether heat stays where it came to be within a cycle of the load.
struct Adiabatic {
  double length = 0, pixel = 0;  ///< that heat diffuses, and the side of a pixel, m; no pixel: unknown

  /// `diffusivity` of heat in the grains, m^2/s; `frequency` of the load, Hz.
  Adiabatic(double diffusivity, double frequency, double side = 0);
  double lost() const;  ///< share of the finest detail's amplitude
  /// At a fifth of a pixel the finest detail loses 2 % of its amplitude and lags by 11 degrees.
  bool holds() const { return length <= pixel / 5; }
  std::string sentence() const;  ///< what to say where it does not hold
};

/// Throws InputError if the film's levels cannot become temperatures in the way that the recipe says.
void refuse_temperatures(const recipe::FilmRecipe& recipe, const std::filesystem::path& path, const FilmInfo& film);

/// Throws InputError if nearly all pixels of a film reach the top of its range.
void refuse_saturated(const thermography::FrameStatistics& seen, const FilmInfo& film);

/// Throws InputError if nearly all pixels of a film stay as they are from its first frame on.
void refuse_constant(const thermography::FrameStatistics& seen, const FilmInfo& film);

/// What to say of maps that show no load, a film without one or at a wrong frequency; `given_by` is the key or option that gives it.
std::string no_load_sentence(const LockinMaps& maps, double frequency, std::string_view given_by);

/// Throws InputError if the maps hold nothing but noise, or a line of the camera.
void refuse_without_load(const LockinMaps& maps, double given_frequency);

/// The recipe of the companion simulation. Throws InputError if it has not the stages that [simulation] names.
recipe::Recipe read_companion_recipe(const recipe::FilmRecipe& recipe);

/// When the film itself says that the load is largest, against what the recipe gives, in cycles from -0.5 to 0.5. A signal
/// that heat does not blur is in phase with the load everywhere; of the two ends the film takes that at which pixels warm.
double phase_off(const LockinMaps& maps, double given_cycles);

/// Throws InputError for maps that cannot be those of a load as the recipe gives it: values that are no temperatures, amplitudes
/// of kelvins, a phase that is off by an eighth of a cycle or more.
void refuse_impossible(const recipe::FilmRecipe& recipe, const LockinMaps& maps);

/// What the forces and the film say against what was given beside them, one sentence each with the likely causes: phase,
/// factors of the materials one against another, the scale of temperatures and forces against the load, and what the fit
/// leaves. Throws InputError where they have nothing to do with each other.
std::vector<std::string> film_doubts(const recipe::FilmRecipe& recipe, const FilmResult& result);

}  // namespace arenite::workflow
