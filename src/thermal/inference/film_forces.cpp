#include "thermal/inference/film_forces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "model/film_place.hpp"
#include "model/lockin_maps.hpp"
#include "statistics/measured.hpp"
#include "thermal/imaging/proposed_contacts.hpp"
#include "thermal/inference/mean_forces.hpp"
#include "thermal/inference/pixel_forces.hpp"

namespace arenite::inference {
namespace {

constexpr double least_place_error =
    0.05;                               // pixels: places of found circles are known better than motion and lens allow
constexpr double sure_errors = 5;       // beyond which a force is no noise
constexpr double surface_error = 0.05;  // pixels: of where a grain's rim is, along a line through its centre

imaging::ContactTolerance tolerance_of(double pixel) { return {.pixel = pixel, .wall_error = 0.1 * pixel}; }

double widest_gap(double pixel) {
  const auto tolerance = tolerance_of(pixel);
  return (tolerance.floor + tolerance.errors * std::sqrt(2.0) * surface_error) * pixel;
}

/// `unseen`: ForceProblem's.
Contacts touching_at_either_load(const Domain& start, const FilmResult& r, const std::vector<double>& unseen) {
  const imaging::ContactTolerance tolerance = tolerance_of(r.pixel);
  imaging::GrainErrors errors{std::vector<double>(r.packing.grains.size(), surface_error * r.pixel), {}};
  for (std::size_t g = 0; g < unseen.size(); ++g) errors.position[g] = std::max(errors.position[g], unseen[g]);
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

ForceOptions force_options(const FilmForcesGiven& given, const PictureGrains& grains) {
  ForceOptions options;
  options.blur = given.blur;
  options.threads = given.threads;
  // Rims sweep over what is behind them; pixels further in are still good to some mK.
  options.rim_margin = given.grains_move ? 1.5 : 0.5;
  options.friction = given.friction;
  options.inequality = given.state ? Inequality::cone : Inequality::none;
  options.own_factors = true;
  options.factor_error = given.fits_factors ? 0 : given.factor_error;
  options.fit_factors = given.fits_factors || options.factor_error > 0;
  options.position_error =
      std::max(least_place_error, statistics::mean_of(grains.position_error).value);  // the least where none is known
  return options;
}

ThermoelasticPicture picture_of(const FilmResult& r) {
  ThermoelasticPicture picture{r.film.width,          r.film.height,      r.pixel, r.origin, r.maps.in_phase,
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
double load_of_film(ForceProblem problem, const ThermoelasticPicture& picture, ForceOptions options) {
  options.inequality = Inequality::none, options.fit_factors = false;
  const auto walls = std::exchange(problem.walls, {});
  return walls.empty() ? 0 : load_on(walls.front().side, infer_from_pixels(problem, picture, options).contacts);
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
ForceFit fit_of_factors(const ForceProblem& problem, const ThermoelasticPicture& picture, ForceOptions options) {
  options.inequality = Inequality::none;
  options.fit_factors = true, options.factor_error = 0, options.iterations = 10;
  return infer_from_pixels(problem, picture, options).fit;
}

}  // namespace

void infer_film_forces(const FilmForcesGiven& given, const Domain& start, FilmResult& r) {
  const auto unseen = mapped(given.unseen, [&](double pixels) { return pixels * r.pixel; });
  r.packing.contacts = touching_at_either_load(start, r, unseen);
  ForceProblem problem{r.packing, mapped(r.packing.materials, &Material::thermoelastic_factor), {}, unseen};
  if (given.load_peak_to_peak > 0)
    problem.walls.push_back({bottom, given.load_peak_to_peak, given.load_error * given.load_peak_to_peak});
  auto options = force_options(given, r.grains);
  options.widest_gap = widest_gap(r.pixel);
  const auto infer = [&](const ForceOptions& o) {
    return given.from_pixels ? infer_from_pixels(problem, picture_of(r), o)
                             : infer_from_means(problem, r.peak_to_peak.sigma_hyd, r.peak_to_peak.error, o);
  };
  // Contacts that carry nothing only take from the others' accuracy; those that opened on the way lost a force.
  // They are told apart before a cone bends their forces.
  ForceOptions first = options;
  first.inequality = Inequality::none;
  const InferredForces all = infer(first);
  std::vector<std::uint8_t> needed, present;
  r.presence.clear();
  for (std::size_t c = 0; c < all.contacts.size(); ++c) {
    // Two grains that turned about each other carry the same force along another line: that is a force across.
    const bool across = std::abs(all.contacts.ft[c]) > sure_errors * all.ft_error[c];
    needed.push_back(all.present[c] || all.idle[c] < 0.5 || across);
    if (!needed.back()) continue;
    present.push_back(all.present[c]);
    r.presence.push_back(all.presence[c]);
  }
  keep(r.packing.contacts, needed, {});
  if (r.packing.contacts.size() == 0) throw InputError(nothing_presses);
  std::optional<ForceFit> free;
  if (given.from_pixels && !given.fits_factors) {
    free = fit_of_factors(problem, picture_of(r), options);
    // Film and load that disagree with the factors say how far these may be off.
    if (options.fit_factors && !problem.walls.empty())
      options.factor_error = std::max(options.factor_error, difference_of_factors(*free));
  }
  InferredForces kept = infer(options);
  if (given.from_pixels) kept.fit.load = load_of_film(problem, picture_of(r), options);
  if (free) kept.fit.factor_scale = free->factor_scale, kept.fit.factor_scale_error = free->factor_scale_error;
  r.fit = std::move(kept.fit);
  r.fit.proposed = all.fit.proposed, r.fit.present = all.fit.present, r.fit.present_error = all.fit.present_error;
  r.packing.contacts = std::move(kept.contacts);
  r.fn_error = std::move(kept.fn_error);
  r.ft_error = std::move(kept.ft_error);
  // From here on the film's contacts are those that are there: one set for all that is reported of it.
  keep(r.packing.contacts, present, {&r.fn_error, &r.ft_error, &r.presence});
}

}  // namespace arenite::inference
