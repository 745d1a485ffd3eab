#include "workflow/film/film_grains.hpp"

#include <fmt/core.h>

#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "io/image/image.hpp"
#include "io/sample/placed_grains.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/imaging/grains_of_picture.hpp"
#include "thermal/imaging/optical_grains.hpp"
#include "thermal/imaging/picked_grains.hpp"

namespace arenite::workflow {

FilmPlace place_of(const recipe::FilmRecipe& recipe, const FilmInfo& film) {
  const auto& container = recipe.container;
  return place_of_container(film.width, film.height, recipe.picture.pixel, {container.width, container.height},
                            container.left, container.top);
}

Domain container_at(const recipe::FilmRecipe& recipe, double share) {
  Domain domain;
  domain.thickness = recipe.container.thickness;
  domain.wall[right].position = recipe.container.width;
  domain.wall[bottom].position = share * recipe.container.travel;
  domain.wall[top].position = recipe.container.height;
  return domain;
}

Materials materials_of(const recipe::FilmRecipe& recipe) {
  return mapped(recipe.materials, [](const recipe::FilmMaterial& m) {
    return Material{m.name, 0, m.stiffness, m.thermoelastic_factor};
  });
}

namespace {

/// Grains of a list that overlap by more than load can press them: each pair is a slip of the list.
void refuse_overlapping(const std::string& file, const Grains& grains) {
  Problems problems(file);
  imaging::each_overlap(grains.position, grains.radius, [&](std::size_t i, std::size_t j, double overlap) {
    problems.add("grains {} and {} overlap by {:.3g} mm, more than the load can cause; correct their centres or radii",
                 grains.id[j], grains.id[i], 1e3 * overlap);
  });
  problems.raise();
}

PictureGrains read_list(const recipe::FilmRecipe& recipe, const FilmPlace& place, std::vector<std::string>& notes) {
  const auto file = recipe.beside(recipe.picture.grains);
  const Grains read = io::read_placed_grains(file, materials_of(recipe), container_at(recipe, 0), notes);
  if (read.size() == 0) refuse(file.string(), "lists no grains; give one row per grain");
  refuse_overlapping(file.string(), read);
  PictureGrains grains;
  grains.centre = mapped(read.position, [&](Vec2 p) { return place.pixels(p); });
  grains.radius = mapped(read.radius, [&](double r) { return r / place.pixel; });
  grains.position_error.assign(read.size(), imaging::listed_position_error);
  grains.material = read.material;
  return grains;
}

void warn_of_gaps(const recipe::FilmRecipe& recipe, const FilmPlace& place, const PictureGrains& grains,
                  std::vector<std::string>& notes) {
  const double share = imaging::covered_share({recipe.container.width, recipe.container.height}, place, grains);
  if (share < imaging::least_covered_share)
    notes.push_back(
        fmt::format("the {} grains that were found cover {:.0f} % of the container; if the sample fills it, give a "
                    "sharper or finer optical picture (picture.optical) or a list of the grains (picture.grains)",
                    grains.size(), 100 * share));
}

imaging::CircleOptions search_of(const recipe::PictureSection& picture) {
  return {.contrast = picture.contrast, .least_score = picture.least_score};
}

/// Circles of the film's own picture, without pores.
PictureGrains film_grains(const recipe::FilmRecipe& recipe, const FilmPlace& place, const FilmInfo& film,
                          const std::vector<float>& frame) {
  auto found = imaging::circles_of(recipe.picture.radii, {film.width, film.height, frame}, place.pixel,
                                   search_of(recipe.picture));
  imaging::keep_inside({recipe.container.width, recipe.container.height}, place, found.grains);
  imaging::drop_overlapping(found.grains);
  if (found.grains.size() > 0 && !found.report.between) imaging::drop_pores(frame, found.report.bright, found.grains);
  return std::move(found.grains);
}

PictureGrains optical_grains(const recipe::FilmRecipe& recipe, const FilmPlace& place, const FloatImage& frame,
                             const LockinMaps& maps, std::vector<std::string>& notes) {
  const auto file = recipe.beside(recipe.picture.optical).string();
  const auto& [container, picture] = std::tie(recipe.container, recipe.picture);
  const imaging::OpticalView view{file,
                                  picture.optical_pixel > 0 ? picture.optical_pixel : picture.pixel,
                                  picture.pixel,
                                  {container.width, container.height},
                                  container.left || container.top,
                                  container.travel,
                                  picture.radii,
                                  search_of(picture)};
  return imaging::optical_grains(io::read_image(file), view, place, frame, maps, notes);
}

}  // namespace

PictureGrains find_film_grains(const recipe::FilmRecipe& recipe, const FilmPlace& place, const FilmInfo& film,
                               const std::vector<float>& frame, const LockinMaps& maps,
                               std::vector<std::string>& notes) {
  if (!recipe.picture.grains.empty()) return read_list(recipe, place, notes);
  const bool optical = !recipe.picture.optical.empty();
  PictureGrains grains = optical ? optical_grains(recipe, place, {film.width, film.height, frame}, maps, notes)
                                 : film_grains(recipe, place, film, frame);
  if (optical)
    imaging::keep_inside({recipe.container.width, recipe.container.height}, place, grains),
        imaging::drop_overlapping(grains);
  if (grains.size() == 0)
    throw InputError(
        "the film shows no grains inside the container; give a list of the grains (picture.grains), or correct "
        "[container]");
  warn_of_gaps(recipe, place, grains, notes);
  imaging::take_materials(mapped(recipe.materials, &recipe::FilmMaterial::brightness),
                          optical ? recipe.picture.optical : "the film", grains);
  return grains;
}

}  // namespace arenite::workflow
