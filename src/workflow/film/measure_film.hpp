#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/film.hpp"
#include "model/film_result.hpp"
#include "recipe/film_recipe.hpp"
#include "workflow/film/run_film.hpp"

namespace arenite::workflow {

/// Measures a film: correction, lock-in, grains in the picture, their motion, stresses and contact forces, into
/// `result`. False if it was stopped. Throws InputError, without the film's name, for what the recipe and the film do
/// not allow.
bool measure_film(const recipe::FilmRecipe& recipe, const FilmRunOptions& options, FilmSource& film,
                  FilmResult& result);

}  // namespace arenite::workflow
