#pragma once
#include <string>
#include <vector>

#include "model/picture_grains.hpp"
#include "study/film_recipe.hpp"

namespace arenite::study {

/// Gives the grains of a film their materials from a picture of an ordinary camera that looks at the same sample from the same
/// place (picture.optical): both pictures have the same middle, but for a shift of up to two pixels of the film, which is found as
/// the one at which grains are most even inside. Brightnesses are parted into as many classes as there are materials. `notes` gets
/// the shift. Throws InputError where the brightnesses cannot be parted.
void take_optical_materials(const FilmRecipe& recipe, int film_width, int film_height, PictureGrains& grains, std::vector<std::string>& notes);

/// Indices of materials from the darkest to the brightest.
std::vector<std::int32_t> by_brightness(const std::vector<FilmMaterial>& materials);

}  // namespace arenite::study
