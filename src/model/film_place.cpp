#include "model/film_place.hpp"

#include <cstdint>

namespace arenite {

Grains in_metres(const PictureGrains& found, const FilmPlace& place) {
  Grains grains;
  grains.resize(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    grains.id[i] = static_cast<std::int64_t>(i) + 1;
    grains.position[i] = place.metres(found.centre[i]);
    grains.radius[i] = found.radius[i] * place.pixel;
    grains.material[i] = found.material[i];
  }
  return grains;
}

}  // namespace arenite
