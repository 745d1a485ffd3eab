#pragma once
#include "core/parameters.hpp"
#include "recipe/film_recipe.hpp"

namespace arenite::study {

/// Every key of a film's recipe.
void declare(ParameterVisitor& visitor, FilmRecipe& recipe);
/// Those of [camera].
void declare(ParameterVisitor& visitor, CameraSection& camera);

}  // namespace arenite::study
