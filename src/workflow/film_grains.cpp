#include "workflow/measure_film.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "io/sample/sample.hpp"

namespace arenite::workflow {

FilmPlace place_of(const recipe::FilmRecipe& recipe, const FilmInfo& film) {
  const double pixel = recipe.picture.pixel;
  const double left_edge =
      recipe.container.left.value_or(0.5 * (film.width - 1) - 0.5 * recipe.container.width / pixel);
  const double top_edge =
      recipe.container.top.value_or(0.5 * (film.height - 1) - 0.5 * recipe.container.height / pixel);
  return {{-left_edge * pixel, recipe.container.height + top_edge * pixel}, pixel};
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

namespace {

/// Leaves those grains of which `stays` (by their number) says so.
template <class Stays> void keep(PictureGrains& grains, const Stays& stays) {
  std::vector<std::uint8_t> kept;
  for (std::size_t i = 0; i < grains.size(); ++i) kept.push_back(stays(i));
  const auto filter = [&](auto&... arrays) {  // those that are filled
    const auto thin = [&](auto& values) {
      std::size_t i = 0;
      std::erase_if(values, [&](const auto&) { return !kept[i++]; });
    };
    (thin(arrays), ...);
  };
  filter(grains.centre, grains.radius, grains.position_error, grains.radius_error, grains.brightness, grains.score,
         grains.material, grains.size_class);
}

/// Screws and edges of the container look round, too.
void keep_inside(const recipe::FilmRecipe& recipe, const FilmPlace& place, PictureGrains& grains) {
  keep(grains, [&](std::size_t i) {
    const Vec2 c = place.metres(grains.centre[i]);
    const double deep = 0.5 * grains.radius[i] * place.pixel;
    return c.x > deep && c.x < recipe.container.width - deep && c.y > deep && c.y < recipe.container.height - deep;
  });
}

/// Share of the smaller radius by which load never presses two grains together.
constexpr double most_overlap = 0.3;

/// Calls see(i, j, overlap) for disks i and j < i that overlap by more than load can press them.
template <class See>
void each_overlap(const std::vector<Vec2>& centre, const std::vector<double>& radius, const See& see) {
  for (std::size_t i = 0; i < centre.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const double overlap = radius[i] + radius[j] - norm(centre[i] - centre[j]);
          overlap > most_overlap * std::min(radius[i], radius[j]))
        see(i, j, overlap);
}

/// Of two circles that overlap so much the one whose rim shows less is no grain.
void drop_overlapping(PictureGrains& grains) {
  std::vector<std::uint8_t> kept(grains.size(), 1);
  each_overlap(grains.centre, grains.radius,
               [&](std::size_t i, std::size_t j, double) { kept[grains.score[i] < grains.score[j] ? i : j] = 0; });
  keep(grains, [&](std::size_t i) { return kept[i]; });
}

double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// A pore between three grains may have a round rim, but it is as dark as what is behind the grains.
void drop_pores(const std::vector<float>& frame, bool bright, PictureGrains& grains) {
  const std::vector<double> levels(frame.begin(), frame.end());
  const double behind = quantile(levels, bright ? 0.02 : 0.98),
               halfway = 0.5 * (behind + quantile(grains.brightness, 0.5));
  keep(grains, [&](std::size_t i) { return bright ? grains.brightness[i] > halfway : grains.brightness[i] < halfway; });
}

/// Grains of a list that overlap by more than load can press them: each pair is a slip of the list.
void refuse_overlapping(const std::string& file, const Grains& grains) {
  Problems problems(file);
  each_overlap(grains.position, grains.radius, [&](std::size_t i, std::size_t j, double overlap) {
    problems.add("grains {} and {} overlap by {:.3g} mm, more than the load can cause; correct their centres or radii",
                 grains.id[j], grains.id[i], 1e3 * overlap);
  });
  problems.raise();
}

PictureGrains read_list(const recipe::FilmRecipe& recipe, const FilmPlace& place) {
  const auto file = recipe.beside(recipe.picture.grains);
  const Grains read = io::read_placed_grains(file, materials_of(recipe), container_at(recipe, 0));
  if (read.size() == 0) refuse(file.string(), "lists no grains; give one row per grain");
  refuse_overlapping(file.string(), read);
  PictureGrains grains;
  grains.centre = mapped(read.position, [&](Vec2 p) { return place.pixels(p); });
  grains.radius = mapped(read.radius, [&](double r) { return r / place.pixel; });
  grains.position_error.assign(read.size(), 0.3);
  grains.material = read.material;
  return grains;
}

/// Grains in a container fill three quarters of it and more; less means that grains were not found.
void warn_of_gaps(const recipe::FilmRecipe& recipe, const FilmPlace& place, const PictureGrains& grains,
                  std::vector<std::string>& notes) {
  constexpr double loose = 0.65;
  double area = 0;
  for (const double r : grains.radius) area += std::numbers::pi * r * r * place.pixel * place.pixel;
  const double share = area / (recipe.container.width * recipe.container.height);
  if (share < loose)
    notes.push_back(
        fmt::format("the {} grains that were found cover {:.0f} % of the container; if the sample fills it, give a "
                    "sharper or finer optical picture (picture.optical) or a list of the grains (picture.grains)",
                    grains.size(), 100 * share));
}

/// Circles of the film's own picture, without pores.
PictureGrains film_grains(const recipe::FilmRecipe& recipe, const FilmPlace& place, const FilmInfo& film,
                          const std::vector<float>& frame) {
  auto found = circles_of(recipe, {film.width, film.height, frame}, place.pixel);
  keep_inside(recipe, place, found.grains);
  drop_overlapping(found.grains);
  if (found.grains.size() > 0 && !found.report.between) drop_pores(frame, found.report.bright, found.grains);
  return std::move(found.grains);
}

}  // namespace

PictureGrains find_film_grains(const recipe::FilmRecipe& recipe, const FilmPlace& place, const FilmInfo& film,
                               const std::vector<float>& frame, const LockinMaps& maps,
                               std::vector<std::string>& notes) {
  if (!recipe.picture.grains.empty()) return read_list(recipe, place);
  const bool optical = !recipe.picture.optical.empty();
  PictureGrains grains =
      optical ? optical_grains(recipe, place, film, frame, maps, notes) : film_grains(recipe, place, film, frame);
  if (optical) keep_inside(recipe, place, grains), drop_overlapping(grains);
  if (grains.size() == 0)
    throw InputError(
        "the film shows no grains inside the container; give a list of the grains (picture.grains), or correct "
        "[container]");
  warn_of_gaps(recipe, place, grains, notes);
  take_materials(recipe, optical ? recipe.picture.optical : "the film", grains);
  return grains;
}

}  // namespace arenite::workflow
