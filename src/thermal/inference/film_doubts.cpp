#include "thermal/inference/film_doubts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/error.hpp"
#include "model/film_place.hpp"
#include "thermal/thermography/film_checks.hpp"
#include "thermal/thermography/lockin.hpp"

namespace arenite::inference {
namespace {

/// Of a cycle: what rims, integration and heat leave at most.
constexpr double phase_doubted = 0.03;
/// Standard errors of the factors as given and as fitted together, from which on they disagree; fitted factors that are
/// off by so much are doubted even where they are asked for; four times are refused.
constexpr double errors_doubted = 3, fitted_doubted = 1.1, scale_refused = 4;
constexpr double blur_doubted = 0.15;  // pixels
/// Share of the signal that fields of real grains may be off by, and of what clean films leave in their pixels.
constexpr double field_doubted = 0.15, noise_doubted = 8;
/// Of the light: a halo that is told.
constexpr double halo_told = 0.01;
/// By which factors of single grains may scatter.
constexpr double scatter_told = 0.02;

std::string percent(double scale) { return fmt::format("{:.2f} times", scale); }

struct Scale {
  std::size_t material;
  double log, error;
};

/// Materials whose scale the film shows.
std::vector<Scale> known_scales(const FilmResult& r) {
  std::vector<Scale> scales;
  for (std::size_t m = 0; m < r.fit.factor_scale.size(); ++m) {
    const auto grains =
        std::count(r.packing.grains.material.begin(), r.packing.grains.material.end(), static_cast<std::int32_t>(m));
    const double scale = r.fit.factor_scale[m], error = r.fit.factor_scale_error[m] / scale;
    if (grains >= 3 && scale > 0) scales.push_back({m, std::log(scale), error});
  }
  return scales;
}

/// What factors differ by beyond what their errors and that of the recipe's factors allow; above 0 where they disagree.
double beyond(const FilmGiven& given, double log, double error, double given_error) {
  const bool fitted = given.fits_factors;
  return std::abs(log) - errors_doubted * std::hypot(error, fitted ? 0 : given_error) -
         (fitted ? std::log(fitted_doubted) : 0);
}

/// The two materials whose factors fit if each takes the other's; common: what all are off by.
const Scale* taken_for(const std::vector<Scale>& scales, const Scale& one, const Materials& materials, double common) {
  const auto factor = [&](const Scale& s) { return std::log(materials[s.material].thermoelastic_factor); };
  for (const Scale& other : scales) {
    if (&other == &one) continue;
    const double apart = factor(other) - factor(one);
    if (std::abs(one.log - common - apart) < 0.25 * std::abs(apart) &&
        std::abs(other.log - common + apart) < 0.25 * std::abs(apart))
      return &other;
  }
  return nullptr;
}

std::string unequal(const Materials& materials, const std::vector<Scale>& scales, const Scale& low, const Scale& high) {
  const std::string &first = materials[low.material].name, &second = materials[high.material].name;
  const double ratio = std::exp(high.log - low.log);
  if (taken_for(scales, low, materials, 0.5 * (low.log + high.log)))
    return fmt::format(
        "forces between {0} and {1} agree only if each has the other's thermoelastic factor: the two materials are "
        "probably swapped; check their brightness (or the list of grains) and their factors",
        first, second);
  return fmt::format(
      "forces between {0} and {1} agree only if the ratio of the factors of {1} and {0} is {2} that of the recipe; "
      "check thermoelastic_factor and emissivity of both",
      first, second, percent(ratio));
}

std::string off_scale(double peak_to_peak, double scale) {
  const double load = 1e-3 * peak_to_peak;
  return fmt::format(
      "the film's temperatures give {} the forces that the peak-to-peak load of {:.4g} kN allows; the likely causes "
      "are load_peak_to_peak or all thermoelastic factors (given as {} their true values), the calibration of "
      "temperatures, emissivities, or thickness",
      percent(scale), load, percent(1 / scale));
}

void add_scales(const FilmGiven& given, const FilmResult& r, std::vector<std::string>& doubts) {
  const auto scales = known_scales(r);
  if (scales.empty()) return;
  const auto [low, high] =
      std::minmax_element(scales.begin(), scales.end(), [](const Scale& a, const Scale& b) { return a.log < b.log; });
  const double factor = given.factor_error, load = given.load_error;
  const bool alike =
      beyond(given, high->log - low->log, std::hypot(high->error, low->error), std::sqrt(2.0) * factor) < 0;
  if (!alike && std::hypot(high->error, low->error) < 1)
    doubts.push_back(unequal(r.packing.materials, scales, *low, *high));
  if (given.load_peak_to_peak <= 0) return;
  double sum = 0, weight = 0, squares = 0;
  for (const Scale& s : scales) {
    const double w = 1 / (s.error * s.error);
    sum += w * s.log, weight += w, squares += w * w;
  }
  const double mean_factor = factor * std::sqrt(squares) / weight;  // factors err each on its own, the load for all
  const double common = alike ? sum / weight : 0.5 * (low->log + high->log);
  if (beyond(given, common, 1 / std::sqrt(weight), std::hypot(mean_factor, load)) < 0) return;
  // Where materials stand for each other their mean is off by what their factors and numbers make it: nothing more to
  // say.
  if (!alike && std::abs(common) < 0.5 * (high->log - low->log)) return;
  const std::string sentence = off_scale(given.load_peak_to_peak, std::exp(common));
  if (std::abs(common) > std::log(scale_refused))
    throw InputError(sentence + "; no forces are inferred from such a film");
  doubts.push_back(sentence);
}

/// Sides that grains show elsewhere than the recipe has them.
void add_walls(const FilmGiven& given, const FilmResult& r, std::vector<std::string>& doubts) {
  const FilmWalls& w = r.walls;
  const FilmPlace said{r.origin + w.shift, r.pixel}, found{r.origin, r.pixel};
  const Vec2 corner{0, given.height}, was = said.pixels(corner), is = found.pixels(corner);
  const auto elsewhere = [&](const char* side, const char* line, double at, double from, double error, const char* key,
                             bool by_key) {
    doubts.push_back(
        fmt::format("the rims of the grains show the container's {} side at {} {:.2f} (+- {:.2f}), not at {:.2f} as "
                    "{}; it is taken there; give {}",
                    side, line, at, error / r.pixel, from,
                    by_key ? fmt::format("container.{} says", key) : "in the middle of the film", key));
  };
  if (w.shift.x != 0) elsewhere("left", "column", is.x, was.x, w.shift_error.x, "left", given.left);
  if (w.shift.y != 0) elsewhere("upper", "row", is.y, was.y, w.shift_error.y, "top", given.top);
  const auto smaller = [&](double by, const char* sides, const char* key) {
    if (by != 0)
      doubts.push_back(fmt::format(
          "grains touch {} only if the container is {:.2g} mm {} than container.{} says; check it, and picture.pixel",
          sides, 1e3 * std::abs(by), by > 0 ? "smaller" : "larger", key));
  };
  smaller(w.smaller.x, "both its left and its right side", "width"),
      smaller(w.smaller.y, "both its upper and its lower side", "height");
  if (w.travel != 0 && given.travel != 0)
    doubts.push_back(
        fmt::format("grains show that the lower wall travels {:.4g} mm, not {:.4g} mm as container.travel says",
                    1e3 * w.travel, 1e3 * given.travel));
}

/// What the lens and the surfaces of single grains do.
void add_optics(const FilmGiven& given, const FilmResult& r, std::vector<std::string>& doubts) {
  if (r.rim_blur > 0 && std::abs(r.rim_blur - given.blur) > blur_doubted)
    doubts.push_back(
        fmt::format("the rims of grains show a blur of {:.2g} pixels, but forces.blur is {:.2g}; give the blur of the "
                    "camera's lens",
                    r.rim_blur, given.blur));
  if (r.halo.share > halo_told && !given.halo)
    doubts.push_back(
        fmt::format("the grains show that the lens scatters {:.2g} % (+- {:.1g} %) of the light over about {:.2g} "
                    "pixels (a halo); it is removed, without which stresses would be off by {:.2g} % of their mean; "
                    "clean the lens, or give forces.halo",
                    100 * r.halo.share, std::max(0.1, 100 * r.halo.error), r.halo.width, 100 * r.halo.cost));
  if (r.fit.factor_scatter > scatter_told)
    doubts.push_back(
        fmt::format("grains of one material differ by {:.2g} % in what they warm by under the forces that balance "
                    "them; the likely causes are uneven emissivity or paint; errors include it",
                    100 * r.fit.factor_scatter));
}

}  // namespace

std::vector<std::string> film_doubts(const FilmGiven& given, const FilmResult& r) {
  std::vector<std::string> doubts;
  if (given.phase) {
    const double off = thermography::phase_off(r.maps, *given.phase / (2 * std::numbers::pi));
    if (std::abs(off) > phase_doubted)
      doubts.push_back(
          fmt::format("grains warm {:.3g} deg off the phase that lockin.phase gives; check it, and that heat does not "
                      "diffuse over pixels within a cycle (`arenite lockin --diffusivity --pixel`)",
                      360 * std::abs(off)));
  }
  if (const thermography::Adiabatic heat(given.diffusivity, r.maps.frequency, r.pixel); !heat.holds())
    doubts.push_back(heat.sentence());
  add_walls(given, r, doubts);
  add_optics(given, r, doubts);
  if (r.packing.contacts.size() == 0) return doubts;
  add_scales(given, r, doubts);
  if (r.fit.model_error > field_doubted || r.fit.over_noise > noise_doubted)
    doubts.push_back(
        fmt::format("forces and pixels agree only if the stress fields of disks are off by {:.0f} % of their signal: "
                    "the residual is {:.0f} % of the signal and {:.3g} times the noise; the likely causes are wrong "
                    "circles, a wrong blur, materials or grains that are not cylinders",
                    100 * r.fit.model_error, 100 * r.fit.over_signal, r.fit.over_noise));
  return doubts;
}

}  // namespace arenite::inference
