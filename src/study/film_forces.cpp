#include "study/film_forces.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

#include "imaging/proposed_contacts.hpp"
#include "inference/contact_forces.hpp"
#include "study/film_place.hpp"

namespace arenite::study {
namespace {

/// Places of found circles are known better than motion and lens allow.
double place_error(const PictureGrains& grains) {
  double sum = 0;
  for (const double e : grains.position_error) sum += e;
  return std::max(0.05, sum / static_cast<double>(std::max<std::size_t>(grains.size(), 1)));
}

Contacts touching_at_either_load(const FilmRecipe& recipe, const FilmResult& r) {
  imaging::ContactTolerance tolerance;
  tolerance.pixel = r.pixel;
  tolerance.wall_error = 0.1 * r.pixel;
  const imaging::GrainErrors errors{std::vector<double>(r.packing.grains.size(), 0.05 * r.pixel), {}};
  Contacts contacts = imaging::propose_contacts(r.packing.grains, r.packing.domain, errors, tolerance);
  const Grains before = in_metres(r.grains, {r.origin, r.pixel});
  const Contacts opened = imaging::propose_contacts(before, frame_at(recipe, 0), errors, tolerance);
  std::set<std::pair<std::int32_t, std::int32_t>> known;
  for (std::size_t c = 0; c < contacts.size(); ++c) known.emplace(contacts.i[c], contacts.j[c]);
  for (std::size_t c = 0; c < opened.size(); ++c)
    if (known.emplace(opened.i[c], opened.j[c]).second)
      contacts.add(opened.i[c], opened.j[c], opened.normal(c), 0, 0, opened.arm_i[c], opened.arm_j[c]);
  return contacts;
}

inference::ForceOptions force_options(const FilmRecipe& recipe, const PictureGrains& grains) {
  inference::ForceOptions options;
  options.blur = recipe.forces.blur;
  // Rims sweep over what is behind them; pixels further in are still good to some mK.
  options.rim_margin = recipe.lockin.motion ? 1.5 : 0.5;
  options.friction = recipe.forces.friction;
  options.inequality = recipe.forces.state ? inference::Inequality::cone : inference::Inequality::none;
  options.position_error = place_error(grains);
  return options;
}

inference::SwingPicture picture_of(const FilmResult& r) {
  inference::SwingPicture picture{r.film.width, r.film.height, r.pixel, r.origin, r.maps.in_phase, r.maps.standard_error};
  const float to_full = r.maps.convention == SwingConvention::full ? 1 : 2;
  for (auto* values : {&picture.value, &picture.error})
    for (float& v : *values) v *= to_full;
  return picture;
}

}  // namespace

void infer_film_forces(const FilmRecipe& recipe, FilmResult& r) {
  using From = ForcesSection::From;
  if (recipe.forces.from == From::none) return;
  r.packing.contacts = touching_at_either_load(recipe, r);
  inference::ForceProblem problem{r.packing, {}, {}};
  for (const FilmMaterial& m : recipe.materials) problem.factor.push_back(m.thermoelastic_factor);
  if (recipe.frame.load_swing > 0) problem.walls.push_back({bottom, recipe.frame.load_swing, 0.005 * recipe.frame.load_swing});
  const auto options = force_options(recipe, r.grains);
  auto inferred = recipe.forces.from == From::pixels ? inference::infer_from_pixels(problem, picture_of(r), options)
                                                     : inference::infer_from_means(problem, r.swing.sigma_hyd, r.swing.error, options);
  r.packing.contacts = std::move(inferred.contacts);
  r.fn_error = std::move(inferred.fn_error);
  r.ft_error = std::move(inferred.ft_error);
  r.absent.clear();
  for (const double s : inferred.spurious) r.absent.push_back(s > 0);
}

}  // namespace arenite::study
