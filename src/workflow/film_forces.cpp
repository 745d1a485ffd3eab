#include "workflow/measure_film.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "statistics/measured.hpp"
#include "thermal/imaging/proposed_contacts.hpp"
#include "thermal/inference/contact_forces.hpp"

namespace arenite::workflow {
namespace {

constexpr double least_place_error =
    0.05;                               // pixels: places of found circles are known better than motion and lens allow
constexpr double surface_error = 0.05;  // pixels: of where a grain's rim is, along a line through its centre

imaging::ContactTolerance tolerance_of(double pixel) { return {.pixel = pixel, .wall_error = 0.1 * pixel}; }

double widest_gap(double pixel) {
  const auto tolerance = tolerance_of(pixel);
  return (tolerance.floor + tolerance.errors * std::sqrt(2.0) * surface_error) * pixel;
}

Contacts touching_at_either_load(const Domain& start, const FilmResult& r) {
  const imaging::ContactTolerance tolerance = tolerance_of(r.pixel);
  const imaging::GrainErrors errors{std::vector<double>(r.packing.grains.size(), surface_error * r.pixel), {}};
  Contacts contacts = imaging::propose_contacts(r.packing.grains, r.packing.domain, errors, tolerance);
  const Grains before = in_metres(r.grains, {r.origin, r.pixel});
  const Contacts opened = imaging::propose_contacts(before, start, errors, tolerance);
  std::set<std::pair<std::int32_t, std::int32_t>> known;
  for (std::size_t c = 0; c < contacts.size(); ++c) known.emplace(contacts.i[c], contacts.j[c]);
  for (std::size_t c = 0; c < opened.size(); ++c)
    if (known.emplace(opened.i[c], opened.j[c]).second)
      contacts.add(opened.i[c], opened.j[c], opened.normal[c], 0, 0, opened.arm_i[c], opened.arm_j[c]);
  return contacts;
}

inference::ForceOptions force_options(const recipe::FilmRecipe& recipe, const PictureGrains& grains) {
  inference::ForceOptions options;
  options.blur = recipe.forces.blur;
  // Rims sweep over what is behind them; pixels further in are still good to some mK.
  options.rim_margin = recipe.lockin.motion ? 1.5 : 0.5;
  options.friction = recipe.forces.friction;
  options.inequality = recipe.forces.state ? inference::Inequality::cone : inference::Inequality::none;
  options.own_factors = true;
  const bool fitted = recipe.forces.factors == recipe::ForcesSection::Factors::fit;
  options.factor_error = fitted ? 0 : recipe.forces.factor_error;
  options.fit_factors = fitted || options.factor_error > 0;
  options.position_error =
      std::max(least_place_error, statistics::mean_of(grains.position_error).value);  // the least where none is known
  return options;
}

inference::ThermoelasticPicture picture_of(const FilmResult& r) {
  inference::ThermoelasticPicture picture{r.film.width,          r.film.height,      r.pixel, r.origin, r.maps.in_phase,
                                          r.maps.standard_error, r.maps.common_error};
  // What all pixels share is one unknown of the fit and no error of single pixels.
  const double common = r.maps.common_error * r.maps.common_error;
  for (float& error : picture.error) {
    const double square = static_cast<double>(error) * static_cast<double>(error);
    error = static_cast<float>(std::sqrt(std::max(square - common, r.maps.own_share * square)));
  }
  const auto to_full = static_cast<float>(to_peak_to_peak(r.maps.convention));
  picture.common_error *= static_cast<double>(to_full);
  for (auto* values : {&picture.value, &picture.error})
    for (float& v : *values) v *= to_full;
  return picture;
}

constexpr const char* nothing_presses =
    "no contact between grains is compressed as the load rises; check lockin.phase, the positions of the grains and "
    "the film";

/// Those contacts of the packing that are wanted, with their forces; `also` is thinned out likewise.
void keep(Contacts& contacts, const std::vector<std::uint8_t>& wanted,
          std::initializer_list<std::vector<double>*> also) {
  const Contacts all = std::move(contacts);
  contacts = {};
  for (std::size_t c = 0; c < all.size(); ++c) {
    if (!wanted[c]) continue;
    for (auto* values : also) (*values)[contacts.size()] = (*values)[c];
    contacts.add(all.i[c], all.j[c], all.normal[c], all.fn[c], all.ft[c], all.arm_i[c], all.arm_j[c]);
    contacts.overlap.back() = all.overlap[c];
  }
  for (auto* values : also) values->resize(contacts.size());
}

double load_on(int side, const Contacts& contacts) {
  double sum = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts.is_wall(c) && contacts.wall_side(c) == side) sum += contacts.fn[c];
  return sum;
}

/// The load by forces that are inferred without it, with the factors as given.
double load_of_film(inference::ForceProblem problem, const inference::ThermoelasticPicture& picture,
                    inference::ForceOptions options) {
  options.inequality = inference::Inequality::none, options.fit_factors = false;
  const auto walls = std::exchange(problem.walls, {});
  return walls.empty() ? 0
                       : load_on(walls.front().side, inference::infer_from_pixels(problem, picture, options).contacts);
}

/// The most by which fitted factors differ from the given ones beyond what their own errors explain, relative; 0 where
/// these explain it.
double difference_of_factors(const ForceFit& fit) {
  constexpr double errors = 3;
  double most = 0;
  for (std::size_t m = 0; m < fit.factor_scale.size(); ++m)
    if (const double off = std::abs(std::log(fit.factor_scale[m]));
        off > errors * fit.factor_scale_error[m] / fit.factor_scale[m])
      most = std::max(most, off);
  return most;
}

/// The factors that fit the film, whatever those given are.
ForceFit fit_of_factors(const inference::ForceProblem& problem, const inference::ThermoelasticPicture& picture,
                        inference::ForceOptions options) {
  options.inequality = inference::Inequality::none;
  options.fit_factors = true, options.factor_error = 0, options.iterations = 10;
  return inference::infer_from_pixels(problem, picture, options).fit;
}

}  // namespace

void infer_film_forces(const recipe::FilmRecipe& recipe, const Domain& start, FilmResult& r) {
  using From = recipe::ForcesSection::From;
  if (recipe.forces.from == From::none) return;
  r.packing.contacts = touching_at_either_load(start, r);
  inference::ForceProblem problem{r.packing, mapped(recipe.materials, &recipe::FilmMaterial::thermoelastic_factor), {}};
  const auto& container = recipe.container;
  if (container.load_peak_to_peak > 0)
    problem.walls.push_back({bottom, container.load_peak_to_peak, container.load_error * container.load_peak_to_peak});
  auto options = force_options(recipe, r.grains);
  options.widest_gap = widest_gap(r.pixel);
  const auto infer = [&](const inference::ForceOptions& o) {
    return recipe.forces.from == From::pixels
               ? inference::infer_from_pixels(problem, picture_of(r), o)
               : inference::infer_from_means(problem, r.peak_to_peak.sigma_hyd, r.peak_to_peak.error, o);
  };
  // Contacts that carry nothing only take from the others' accuracy; those that opened on the way lost a force.
  // They are told apart before a cone bends their forces.
  inference::ForceOptions first = options;
  first.inequality = inference::Inequality::none;
  const InferredForces all = infer(first);
  std::vector<std::uint8_t> needed, present;
  r.presence.clear();
  for (std::size_t c = 0; c < all.contacts.size(); ++c) {
    needed.push_back(all.present[c] || all.idle[c] < 0.5);
    if (!needed.back()) continue;
    present.push_back(all.present[c]);
    r.presence.push_back(all.presence[c]);
  }
  keep(r.packing.contacts, needed, {});
  if (r.packing.contacts.size() == 0) throw InputError(nothing_presses);
  std::optional<ForceFit> free;
  if (recipe.forces.from == From::pixels && recipe.forces.factors == recipe::ForcesSection::Factors::given) {
    free = fit_of_factors(problem, picture_of(r), options);
    // Film and load that disagree with the factors say how far these may be off.
    if (options.fit_factors && !problem.walls.empty())
      options.factor_error = std::max(options.factor_error, difference_of_factors(*free));
  }
  InferredForces kept = infer(options);
  if (recipe.forces.from == From::pixels) kept.fit.load = load_of_film(problem, picture_of(r), options);
  if (free) kept.fit.factor_scale = free->factor_scale, kept.fit.factor_scale_error = free->factor_scale_error;
  r.fit = std::move(kept.fit);
  r.fit.proposed = all.fit.proposed, r.fit.present = all.fit.present, r.fit.present_error = all.fit.present_error;
  r.packing.contacts = std::move(kept.contacts);
  r.fn_error = std::move(kept.fn_error);
  r.ft_error = std::move(kept.ft_error);
  // From here on the film's contacts are those that are there: one set for all that is reported of it.
  keep(r.packing.contacts, present, {&r.fn_error, &r.ft_error, &r.presence});
}

}  // namespace arenite::workflow
