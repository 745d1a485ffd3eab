#pragma once
#include "core/vec2.hpp"
#include "model/film.hpp"
#include "model/picture_grains.hpp"
#include "model/packing.hpp"
#include "recipe/film_recipe.hpp"

namespace arenite::study {

/// The one place where rows that point down become heights: pixels of a film as metres from the frame's lower left inner
/// corner at the smallest load.
struct FilmPlace {
  Vec2 origin;                      ///< centre of the upper left pixel, m
  double pixel = 1;                 ///< m
  Vec2 metres(double column, double row) const { return {origin.x + column * pixel, origin.y - row * pixel}; }
  double column(double x) const { return (x - origin.x) / pixel; }
  double row(double y) const { return (origin.y - y) / pixel; }
};

/// Where the recipe says the frame is in the picture, or in its middle.
FilmPlace place_of(const FilmRecipe& recipe, const FilmInfo& film);

/// The frame when the load is at this share of its swing; the lower wall has travelled so far.
Domain frame_at(const FilmRecipe& recipe, double share);

/// Materials of the recipe, with what a film does not know left 0.
Materials materials_of(const FilmRecipe& recipe);

/// Grains of a picture in metres, numbered from 1.
Grains in_metres(const PictureGrains& grains, const FilmPlace& place);

}  // namespace arenite::study
