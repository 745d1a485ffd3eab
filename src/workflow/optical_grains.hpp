#pragma once
#include <string>
#include <vector>

#include "model/film.hpp"
#include "model/picture_grains.hpp"
#include "recipe/film_recipe.hpp"

namespace arenite::study {

/// Grains found in an ordinary camera's picture of the sample at the smallest load (picture.optical) and carried to where
/// `frame`, the film's own picture at that load, shows them; in the film's pixels, with brightnesses of the optical picture
/// and no materials. Both pictures nearly have the same middle (8 pixels of the film, 2 degrees); one that lies elsewhere is laid
/// on grains that the film itself shows. `notes` gets how the pictures lie. Throws InputError where there are no grains or they fit
/// nowhere.
PictureGrains optical_grains(const FilmRecipe& recipe, const FilmInfo& film, const std::vector<float>& frame, std::vector<std::string>& notes);

/// Materials of grains by their brightness, parted into as many classes as the recipe has materials; `where` names the picture in
/// the InputError for one that cannot be parted.
void take_materials(const FilmRecipe& recipe, const std::string& where, PictureGrains& grains);

/// Grains of one class have one radius, which their mean tells better than each by itself.
void take_class_radii(const std::vector<double>& class_radius, PictureGrains& grains);

}  // namespace arenite::study
