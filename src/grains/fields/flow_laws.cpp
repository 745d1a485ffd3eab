#include "grains/fields/flow_laws.hpp"

#include <algorithm>
#include <cmath>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "statistics/correlation.hpp"
#include "statistics/measured.hpp"

namespace arenite::fields {
namespace {

using Values = std::vector<double>;

constexpr double scatter_of_front = 0.05;  // of a run-out: all weigh alike

}  // namespace

std::vector<statistics::Estimate> roots_of_rates(const Values& rate, const Values& error, double exponent) {
  const double root = 1 / exponent;
  std::vector<statistics::Estimate> roots;
  for (std::size_t k = 0; k < rate.size(); ++k)
    roots.push_back({std::pow(rate[k], root), root * error[k] * std::pow(rate[k], root - 1)});
  return roots;
}

BeverlooLaw fit_beverloo(const Values& opening, const Values& rate, const Values& error,
                         std::optional<double> exponent) {
  if (opening.size() != rate.size() || rate.size() < 2)
    throw refusal("a law of discharge needs two openings with their rates at least; there are {} and {}",
                  opening.size(), rate.size());
  const auto [narrowest, widest] = std::ranges::minmax(opening);
  if (!(narrowest > 0 && widest > narrowest))
    throw refusal("the openings lie from {:g} to {:g} m; a law of discharge needs two that differ, above 0", narrowest,
                  widest);
  if (exponent && !(*exponent > 0)) throw refusal("an exponent of {:g} is not possible; give one above 0", *exponent);
  const double n = exponent.value_or(1.5);
  const auto line = statistics::second_moments(opening, mapped(rate, [&](double w) { return std::pow(w, 1 / n); }));
  const double slope = line.xx > 0 && line.xy > 0 ? line.xy / line.xx : 1;
  Values start{std::pow(slope, n), std::max(line.mean_x - line.mean_y / slope, 0.0)};
  if (!exponent) start.push_back(n);
  const auto law = [n](double d, const Values& p) {
    return p[0] * std::pow(std::max(d - p[1], 1e-9), p.size() > 2 ? p[2] : n);
  };
  const auto found = statistics::fit_law(law, start, opening, rate, error);
  return {found[0], found[1], exponent ? statistics::Estimate{n} : found[2]};
}

RunoutLaws fit_runout(const Values& aspect_ratio, const Values& runout, double low, double high) {
  if (aspect_ratio.size() != runout.size())
    throw refusal("there are {} aspect ratios and {} run-outs; give as many", aspect_ratio.size(), runout.size());
  if (std::ranges::any_of(aspect_ratio, [](double a) { return !std::isfinite(a); }))
    throw InputError("an aspect ratio is not a number; leave out its run");
  const auto law_where = [&](const auto& holds) -> std::optional<statistics::PowerLaw> {
    Values x, y, error;
    for (std::size_t k = 0; k < runout.size(); ++k)
      if (holds(aspect_ratio[k]))
        x.push_back(aspect_ratio[k]), y.push_back(runout[k]), error.push_back(scatter_of_front * runout[k]);
    if (x.size() < least_points_of_law || std::ranges::min(x) == std::ranges::max(x)) return {};
    return statistics::fit_power(x, y, error);
  };
  return {law_where([&](double a) { return a <= low; }), law_where([&](double a) { return a >= high; })};
}

JanssenLaw fit_janssen(const Values& height, const Values& pressure, const Values& error, const Values& hydrostatic) {
  if (height.size() != hydrostatic.size() || height.size() != pressure.size() || height.size() < 2)
    throw InputError("Janssen's law needs the height, the pressure and the hydrostatic pressure of two silos at least");
  const double most = *std::ranges::max_element(pressure);
  double steepest = 1e-300;
  for (std::size_t k = 0; k < height.size(); ++k) steepest = std::max(steepest, hydrostatic[k] / height[k]);
  const auto law = [](double h, const Values& p) { return -p[0] * std::expm1(-h / p[1]); };
  const auto found = statistics::fit_law(law, {most, most / steepest}, height, pressure, error);
  return {found[0], found[1]};
}

statistics::Estimate length_by_stresses(const Values& width, const Values& wall_friction, const Values& ratio) {
  if (width.size() != wall_friction.size() || width.size() != ratio.size())
    throw InputError("a length by stresses needs the width, the wall friction and the ratio of stresses of each silo");
  Values lengths;
  for (std::size_t k = width.size() / 2; k < width.size(); ++k)
    lengths.push_back(width[k] / (2 * wall_friction[k] * ratio[k]));
  const auto mean = statistics::mean_of(lengths);
  return {mean.value, mean.error};
}

}  // namespace arenite::fields
