#pragma once
#include "model/film_result.hpp"
#include "recipe/film_recipe.hpp"

namespace arenite::study {

/// Proposes contacts between the grains of `result.packing` and infers their forces from its maps, or from the means of
/// grains, as the recipe's [forces] says. Contacts are proposed where grains touch at the largest or at the smallest load
/// (`result.grains`): one that opens on the way loses its force.
void infer_film_forces(const FilmRecipe& recipe, FilmResult& result);

}  // namespace arenite::study
