#pragma once
#include <string>
#include <vector>

#include "model/domain.hpp"
#include "model/film.hpp"
#include "model/film_place.hpp"
#include "model/image.hpp"
#include "model/lockin_maps.hpp"
#include "model/packing.hpp"
#include "recipe/film_recipe.hpp"

namespace arenite::workflow {

/// Where the recipe says the container is in the picture, or in its middle.
FilmPlace place_of(const recipe::FilmRecipe& recipe, const FilmInfo& film);

/// The container when the load has gone this share from its smallest to its largest; the lower wall has travelled so
/// far.
Domain container_at(const recipe::FilmRecipe& recipe, double share);

/// Materials of the recipe, with what a film does not know left 0.
Materials materials_of(const recipe::FilmRecipe& recipe);

/// Grains at the smallest load, in the film's pixels, with materials as the recipe numbers them: hand-made
/// (picture.grains), or found in the optical picture and laid over the film, or found in `frame`, the film's own
/// picture at that load (K or levels, rows from the top). An optical picture is laid over the amplitudes of `maps`
/// where the frame has no contrast. `notes` gets what a user should know. Throws InputError where there are no grains,
/// or as many brightnesses as materials cannot be told apart.
PictureGrains find_film_grains(const recipe::FilmRecipe& recipe, const FilmPlace& place, const FilmInfo& film,
                               const std::vector<float>& frame, const LockinMaps& maps,
                               std::vector<std::string>& notes);

}  // namespace arenite::workflow
