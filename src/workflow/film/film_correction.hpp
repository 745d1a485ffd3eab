#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/film.hpp"
#include "recipe/film_recipe.hpp"
#include "thermal/thermography/correction.hpp"
#include "thermal/thermography/load_signal.hpp"

namespace arenite::workflow {

/// What is done to a film before it is looked at, as its recipe says.
struct FilmCorrection {
  thermography::Correction correction;
  std::vector<std::uint8_t> bad;  ///< 1 for pixels that are replaced
  thermography::GrainSurfaces
      surfaces;  ///< what is left to do where materials are known: their emissivities, if these differ
  std::vector<std::string> notes;  ///< what a user should know: constant or saturated pixels
};

/// Throws InputError if the film's levels cannot become temperatures in the way that the recipe says.
void refuse_temperatures(const recipe::FilmRecipe& recipe, const std::filesystem::path& path, const FilmInfo& film);

/// Reads references and curve, and looks at the film's first frames for bad pixels. Throws InputError for references of
/// another size and films that do not hold what [temperature] says.
FilmCorrection make_correction(const recipe::FilmRecipe& recipe, FilmSource& film);

/// The load's cycle from the lock-in line of a .ptw film; nothing for films without. `notice` is called where the line
/// shows no cycle near the given frequency, or another one.
std::optional<thermography::LoadSignal> load_signal_of(const std::filesystem::path& path, const FilmInfo& film,
                                                       double given,
                                                       const std::function<void(const std::string&)>& notice);

}  // namespace arenite::workflow
