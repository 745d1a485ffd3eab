#include "grains/fields/laboratory/axial_tests.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mapped.hpp"
#include "statistics/correlation.hpp"

namespace arenite::fields {
namespace {

using Values = std::vector<double>;

constexpr double fallen = 0.1;    // of the largest stress: a sample that has lost as much has failed
constexpr double pressed = 0.01;  // of the largest stress: a sample that bears as much at first is one

/// Slope of stress over strain from one row to another.
double slope_between(const Values& strain, const Values& stress, std::size_t first, std::size_t last) {
  if (last < first + 2) return statistics::unknown;
  const auto from = [&](const Values& v) {
    return Values(v.begin() + static_cast<std::ptrdiff_t>(first), v.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  };
  return statistics::fit_line(from(strain), from(stress)).slope;
}

std::size_t first_above(const Values& stress, double level) {
  return static_cast<std::size_t>(std::ranges::find_if(stress, [&](double v) { return v >= level; }) - stress.begin());
}

const Values& stress_along(const Loading& loading) { return loading.curves[loading.upright ? "sigma_yy" : "sigma_xx"]; }

}  // namespace

std::optional<UniaxialTest> uniaxial_test(const TestCurves& curves) {
  if (curves.confined || curves.sheared) return {};
  UniaxialTest found;
  found.in_tension = curves.strain.back() < 0;
  const auto as_size = [&](const Values& v) { return mapped(v, [&](double a) { return found.in_tension ? -a : a; }); };
  const Values strain = as_size(curves.strain), stress = as_size(curves.ratio);
  const auto peak = std::ranges::max_element(stress);
  found.peak = static_cast<std::size_t>(peak - stress.begin());
  found.strength = *peak, found.strain = strain[found.peak];
  if (!(found.strength > 0)) return {};
  found.failed = *std::min_element(peak, stress.end()) < (1 - fallen) * found.strength;
  found.modulus = slope_between(strain, stress, first_above(stress, 0.1 * found.strength),
                                first_above(stress, 0.5 * found.strength));
  return found;
}

bool is_oedometric(const Test& test, const TestCurves& curves) {
  if (curves.sheared || !curves.confined) return false;
  for (std::size_t k = 0; k < curves.strain.size(); ++k)
    if (!(std::abs(curves.volume[k] - curves.strain[k]) <= 1e-9)) return false;
  const auto loading = loading_of(test);
  if (!loading || !loading->curves.has("sigma_xx") || !loading->curves.has("sigma_yy")) return false;
  if (test.stage.asked.in_motion) return true;
  if (test.before) return test.before->contacts.size() > 0;
  const Values& along = stress_along(*loading);
  return along.front() > pressed * std::ranges::max(along);
}

std::optional<OedometerTest> oedometer_test(const Test& test, const TestCurves& curves) {
  const auto loading = loading_of(test);
  if (!is_oedometric(test, curves)) return {};
  const Values &along = stress_along(*loading), &across = loading->curves[loading->upright ? "sigma_xx" : "sigma_yy"];
  const auto most = static_cast<std::size_t>(std::ranges::max_element(along) - along.begin());
  if (!(along[most] > 0) || !(along.back() > 0)) return {};
  return OedometerTest{along.back(), curves.strain.back(), across.back() / along.back(),
                       slope_between(curves.strain, along, first_above(along, 0.5 * along[most]), most)};
}

}  // namespace arenite::fields
