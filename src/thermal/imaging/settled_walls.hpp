#pragma once
#include "model/domain.hpp"
#include "model/film_place.hpp"
#include "model/film_result.hpp"
#include "model/image.hpp"

namespace arenite::imaging {

/// The container as it is given.
struct FilmContainers {
  Domain start, shown;  ///< at the smallest load, and when the grains are where maps show them
  bool moves = true;    ///< these are those at the largest load
  double travel = 0;    ///< of the lower wall between the two loads, m
};

/// Puts the walls of `result` where the rims of grains show them: the container as a whole goes to its place in the
/// film (`place`), and what is left to single sides. `loaded` are the grains where maps show them. The container at the
/// smallest load.
Domain settle_walls(const FilmContainers& given, const PictureGrains& loaded, FilmPlace& place, FilmResult& result);

}  // namespace arenite::imaging
