#pragma once
#include "model/lockin_maps.hpp"
#include "study/film_recipe.hpp"
#include "study/recipe.hpp"

namespace arenite::study {

/// Mean of the squared amplitude over the squared standard error of the maps' pixels: 2 where noise alone swings.
double swing_over_noise(const LockinMaps& maps);

/// Throws InputError if the maps hold nothing but noise: a film without a load, or told a wrong frequency.
void refuse_without_load(const LockinMaps& maps, double told_frequency);

/// The recipe of the simulation beside the film. Throws InputError if it has not the stages that [twin] names.
Recipe read_twin_recipe(const FilmRecipe& recipe);

}  // namespace arenite::study
