#include "thermal/identify/adhesion.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "thermal/identify/regression.hpp"

namespace arenite::identify {
namespace {

constexpr std::ptrdiff_t points_before = 10, fewest_before = 5;

/// Scatter of the points up to the peak about their straight line, the peak left out: it was chosen for being high.
statistics::Measured peak_with_noise(const Curve& curve, std::ptrdiff_t peak) {
  const double value = curve.y[static_cast<std::size_t>(peak)];
  const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, peak - points_before), count = peak - first;
  if (count < fewest_before) return {value};
  const std::vector<double> x(curve.x.begin() + first, curve.x.begin() + peak), y(curve.y.begin() + first, curve.y.begin() + peak);
  const Regression line = regress(x, y);
  if (!std::isfinite(line.slope.value)) return {value};
  double squares = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double residual = y[k] - line.intercept.value - line.slope.value * x[k];
    squares += residual * residual;
  }
  const double freedom = static_cast<double>(count - 2);
  return {value, std::sqrt(squares / freedom), freedom};
}

}  // namespace

PullOff pull_off(const Curve& curve) {
  const std::string of = curve.name.empty() ? "" : curve.name + ": ";
  if (curve.y.size() < 3)
    throw InputError(curve.file, curve.line.empty() ? 0 : curve.line.front(), of + "a pull-off record needs at least three points; give the whole record");
  const auto at = std::max_element(curve.y.begin(), curve.y.end());
  const std::ptrdiff_t peak = at - curve.y.begin();
  if (!(*at > 0))
    throw InputError(curve.file, curve.line[static_cast<std::size_t>(peak)], of + "the force is never a tension; write tension as positive force");
  PullOff result{peak_with_noise(curve, peak), false};
  result.separated = std::any_of(at, curve.y.end(), [&](double force) { return force <= 0.5 * *at; });
  return result;
}

statistics::Measured surface_energy(const statistics::Measured& separation_force, const statistics::Measured& stiffness, double radius) {
  return statistics::product({{{4 / radius}, 0.5}, {stiffness, 0.5}, {separation_force, 0.5}});
}

Threshold threshold(double gamma, double k, double radius) {
  const double h = radius * gamma * gamma / (k * k);
  return {0.25 * k * h, 0.25 * h, h};
}

}  // namespace arenite::identify
