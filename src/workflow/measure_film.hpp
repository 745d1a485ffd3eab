#pragma once
#include "model/film_result.hpp"
#include "workflow/film_road.hpp"

namespace arenite::study {

/// Measures a film: correction, lock-in, grains in the picture, their motion, stresses and contact forces, into `result`.
/// False if it was stopped. Throws InputError, without the film's name, for what the recipe and the film do not allow.
bool measure_film(const FilmRecipe& recipe, const FilmRunOptions& options, FilmSource& film, FilmResult& result);

}  // namespace arenite::study
