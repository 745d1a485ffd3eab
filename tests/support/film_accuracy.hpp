#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "model/film_result.hpp"
#include "recipe/film_recipe.hpp"
#include "support/laboratory_film.hpp"
#include "support/laboratory_sample.hpp"
#include "workflow/film/measure_film.hpp"

namespace arenite::test {

/// What was found of a film, held against the truth.
struct FilmAccuracy {
  std::size_t grains = 0, contacts = 0, true_contacts = 0;
  double centres = 0, centres_told = 0;          ///< pixels, along one axis, at the largest load
  double centres_low = 0, centres_low_told = 0;  ///< likewise, at the smallest
  double scale = 0;                              ///< by which centres lie too far from each other, relative
  double stress = 0, stress_told = 0;            ///< rms over the mean stress
  double force = 0, force_told = 0;              ///< of normal forces, relative
  double within_one = 0, within_two = 0;         ///< shares of forces
  std::size_t forces = 0;                        ///< of how many
  double common = 0;                             ///< by which all forces are too large together, relative
  double stress_within_one = 0, stress_within_two = 0;
  std::vector<std::string> said;
  FilmResult result;
};

/// By how much places lie farther from their middle than the true ones, relative.
inline double scale_between(const std::vector<Vec2>& truth, const std::vector<Vec2>& found) {
  Vec2 middle, there;
  const auto n = static_cast<double>(truth.size());
  for (std::size_t k = 0; k < truth.size(); ++k) middle += truth[k] / n, there += found[k] / n;
  double along = 0, square = 0;
  for (std::size_t k = 0; k < truth.size(); ++k)
    along += dot(truth[k] - middle, found[k] - there), square += dot(truth[k] - middle, truth[k] - middle);
  return square > 0 ? along / square - 1 : 0;
}

/// The true grain of each that was found.
using TrueGrains = std::map<std::size_t, std::size_t>;

/// Of the lower wall at the smallest load.
inline Vec2 shift_of(const LaboratoryFilm& how) { return {0, how.travel * how.pixel}; }

inline TrueGrains true_grains(const Packing& truth, const Packing& found, Vec2 shift) {
  TrueGrains true_of;
  for (std::size_t i = 0; i < found.grains.size(); ++i)
    for (std::size_t j = 0; j < truth.grains.size(); ++j)
      if (norm(found.grains.position[i] - truth.grains.position[j] - shift) < 0.5 * truth.grains.radius[j])
        true_of[i] = j;
  return true_of;
}

/// Of the true forces on each grain, Pa.
inline std::vector<double> hydrostatic_stresses(const Packing& truth) {
  std::vector<double> sigma(truth.grains.size(), 0.0);
  for (std::size_t c = 0; c < truth.contacts.size(); ++c)
    for (const auto g : {truth.contacts.i[c], truth.contacts.j[c]})
      if (g >= 0) {
        const auto k = static_cast<std::size_t>(g);
        sigma[k] -= truth.contacts.fn[c] / (2 * std::numbers::pi * truth.grains.radius[k] * truth.domain.thickness);
      }
  return sigma;
}

inline void judge_grains(FilmAccuracy& a, const Packing& truth, const LaboratoryFilm& how, const FilmResult& result,
                         const TrueGrains& true_of) {
  const Packing& found = result.packing;
  const Vec2 shift = shift_of(how);
  const std::vector<double> sigma = hydrostatic_stresses(truth);
  double mean = 0, n = 0;
  const std::vector<Vec2> low = how.start(truth);
  std::vector<Vec2> true_places, found_places;
  for (const auto& [i, j] : true_of) {
    const double off = result.peak_to_peak.sigma_hyd[i] - sigma[j], told = result.peak_to_peak.error[i];
    if (!std::isfinite(off) || !std::isfinite(told)) continue;
    mean -= sigma[j], n += 1;
    a.stress += off * off, a.stress_told += told * told;
    a.stress_within_one += std::abs(off) < told, a.stress_within_two += std::abs(off) < 2 * told;
    const Vec2 away = (1 / how.pixel) * (found.grains.position[i] - truth.grains.position[j] - shift);
    a.centres += 0.5 * dot(away, away);
    if (result.grains.position_error.empty()) continue;
    const double motion = i < result.motion.size() ? 2 * result.motion.error[i] : 0,
                 at_rest = result.grains.position_error[i];
    a.centres_told += at_rest * at_rest + motion * motion;
    const Vec2 there{how.left() + low[j].x / how.pixel,
                     how.top_row() + (truth.domain.wall[top].position - low[j].y) / how.pixel},
        astray = result.grains.centre[i] - there;
    a.centres_low += 0.5 * dot(astray, astray), a.centres_low_told += at_rest * at_rest;
    true_places.push_back(there), found_places.push_back(result.grains.centre[i]);
  }
  a.scale = scale_between(true_places, found_places);
  for (double* v : {&a.stress, &a.stress_told}) *v = std::sqrt(*v / n) / (mean / n);
  for (double* v : {&a.centres, &a.centres_told, &a.centres_low, &a.centres_low_told}) *v = std::sqrt(*v / n);
  a.stress_within_one /= n, a.stress_within_two /= n;
}

inline void judge_forces(FilmAccuracy& a, const Packing& truth, const FilmResult& result, const TrueGrains& true_of) {
  const Packing& found = result.packing;
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> contact_of;
  for (std::size_t c = 0; c < truth.contacts.size(); ++c) contact_of[{truth.contacts.i[c], truth.contacts.j[c]}] = c;
  std::vector<double> carried(truth.contacts.size(), 0.0);
  a.contacts = found.contacts.size(), a.true_contacts = truth.contacts.size();
  double squares = 0, one = 0, two = 0, along = 0, held = 0;
  for (std::size_t c = 0; c < found.contacts.size(); ++c) {
    const auto place = [&](std::int32_t g) -> std::int32_t {
      if (g < 0) return g;
      const auto at = true_of.find(static_cast<std::size_t>(g));
      return at == true_of.end() ? 1000000 : static_cast<std::int32_t>(at->second);
    };
    auto i = place(found.contacts.i[c]), j = place(found.contacts.j[c]);
    if (j >= 0 && j < i) std::swap(i, j);
    const auto at = contact_of.find({i, j});
    const double fn = found.contacts.fn[c], told = result.fn_error[c];
    if (at == contact_of.end()) {
      a.force += fn * fn;  // nothing is there
      continue;
    }
    const double off = fn - truth.contacts.fn[at->second];
    carried[at->second] = 1;
    a.force += off * off, a.force_told += told * told, ++a.forces;
    one += std::abs(off) < told, two += std::abs(off) < 2 * told;
    along += off * truth.contacts.fn[at->second], held += truth.contacts.fn[at->second] * truth.contacts.fn[at->second];
  }
  for (std::size_t c = 0; c < truth.contacts.size(); ++c) {
    squares += truth.contacts.fn[c] * truth.contacts.fn[c];
    if (carried[c] == 0) a.force += truth.contacts.fn[c] * truth.contacts.fn[c];
  }
  a.force = std::sqrt(a.force / squares), a.force_told = std::sqrt(a.force_told / squares);
  const auto matched = static_cast<double>(a.forces);
  a.within_one = one / matched, a.within_two = two / matched;
  a.common = held > 0 ? along / held : 0;
}

inline FilmAccuracy judged(const Packing& truth, const LaboratoryFilm& how, FilmResult result,
                           std::vector<std::string> said) {
  FilmAccuracy a;
  a.said = std::move(said);
  const TrueGrains true_of = true_grains(truth, result.packing, shift_of(how));
  a.grains = true_of.size();
  judge_grains(a, truth, how, result, true_of);
  judge_forces(a, truth, result, true_of);
  a.result = std::move(result);
  return a;
}

/// Measures the film by the recipe and holds it against the sample.
inline FilmAccuracy measured(const LaboratorySample& sample, const LaboratoryFilm& how, DrawnFilm& drawn,
                             const recipe::FilmRecipe& recipe) {
  workflow::FilmRunOptions options;
  std::vector<std::string> said;
  options.notice = [&](const std::string& sentence) { said.push_back(sentence); };
  FilmResult result;
  workflow::measure_film(recipe, options, drawn.film, result);
  return judged(sample.packing, how, std::move(result), std::move(said));
}

}  // namespace arenite::test
