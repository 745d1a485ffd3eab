#pragma once
#include <string>
#include <vector>

#include "model/film.hpp"
#include "model/picture_grains.hpp"
#include "workflow/film_place.hpp"
#include "recipe/film_recipe.hpp"

namespace arenite::study {

/// Grains at the smallest load, in the film's pixels, with materials as the recipe numbers them: hand-made (picture.grains),
/// or found in the optical picture and laid over the film, or found in `frame`, the film's own picture at that load (K or
/// levels, rows from the top). `notes` gets what a user should know. Throws InputError where there are no grains, or as many
/// brightnesses as materials cannot be told apart.
PictureGrains find_film_grains(const FilmRecipe& recipe, const FilmPlace& place, const FilmInfo& film, const std::vector<float>& frame,
                               std::vector<std::string>& notes);

}  // namespace arenite::study
