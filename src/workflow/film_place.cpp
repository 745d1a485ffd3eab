#include "workflow/film_place.hpp"

namespace arenite::study {

FilmPlace place_of(const FilmRecipe& recipe, const FilmInfo& film) {
  const double pixel = recipe.picture.pixel;
  const double left_edge = recipe.frame.left.value_or(0.5 * (film.width - 1) - 0.5 * recipe.frame.width / pixel);
  const double top_edge = recipe.frame.top.value_or(0.5 * (film.height - 1) - 0.5 * recipe.frame.height / pixel);
  return {{-left_edge * pixel, recipe.frame.height + top_edge * pixel}, pixel};
}

Domain frame_at(const FilmRecipe& recipe, double share) {
  Domain domain;
  domain.thickness = recipe.frame.thickness;
  domain.wall[right].position = recipe.frame.width;
  domain.wall[bottom].position = share * recipe.frame.travel;
  domain.wall[top].position = recipe.frame.height;
  return domain;
}

Materials materials_of(const FilmRecipe& recipe) {
  Materials materials;
  for (const FilmMaterial& m : recipe.materials) materials.push_back({m.name, 0, m.stiffness, m.thermoelastic_factor});
  return materials;
}

Grains in_metres(const PictureGrains& found, const FilmPlace& place) {
  Grains grains;
  grains.resize(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Vec2 centre = place.metres(found.x[i], found.y[i]);
    grains.id[i] = static_cast<std::int64_t>(i) + 1;
    grains.x[i] = centre.x;
    grains.y[i] = centre.y;
    grains.radius[i] = found.radius[i] * place.pixel;
    grains.material[i] = found.material[i];
  }
  return grains;
}

}  // namespace arenite::study
