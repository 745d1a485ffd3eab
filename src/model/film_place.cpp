#include "model/film_place.hpp"

#include <cstdint>

namespace arenite {

FilmPlace place_of_container(int columns, int rows, double pixel, Vec2 container, std::optional<double> left,
                             std::optional<double> top) {
  const double left_edge = left.value_or(0.5 * (columns - 1) - 0.5 * container.x / pixel);
  const double top_edge = top.value_or(0.5 * (rows - 1) - 0.5 * container.y / pixel);
  return {{-left_edge * pixel, container.y + top_edge * pixel}, pixel};
}

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
