#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "model/film.hpp"
#include "recipe/film_recipe.hpp"
#include "io/film.hpp"
#include "thermal/thermography/correction.hpp"
#include "thermal/thermography/grain_surfaces.hpp"

namespace arenite::study {

/// What is done to a film before it is looked at, as its recipe says.
struct FilmCorrection {
  thermography::Correction correction;
  std::vector<std::uint8_t> bad;    ///< 1 for pixels that are replaced
  thermography::GrainSurfaces surfaces;  ///< what is left to do where materials are known: their emissivities, if these differ
  bool kelvin = false;              ///< what comes out are temperatures
  std::vector<std::string> notes;   ///< what a user should know: constant or saturated pixels
};

/// How the film and its plates are to be read, where the recipe says it.
io::FilmChoice reading_of(const FilmRecipe& recipe);

/// Reads plates and curve, and looks at the film's first frames for bad pixels. Throws InputError for plates of another size
/// and films that do not hold what [temperature] says.
FilmCorrection make_correction(const FilmRecipe& recipe, FilmSource& film);

}  // namespace arenite::study
