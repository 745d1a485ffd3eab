#include "grains/fields/laboratory/axial_tests.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mapped.hpp"
#include "statistics/correlation.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::fields {
namespace {

using Values = std::vector<double>;

constexpr std::size_t parts = 8;  // of the way over which a modulus is taken, for its error
constexpr double fallen = 0.1;    // of the largest stress: a sample that has lost as much has failed

/// Slope of stress over strain from one row to another.
statistics::Estimate slope_between(const Values& strain, const Values& stress, std::size_t first, std::size_t last) {
  if (last < first + 2) return {};
  statistics::Items rows;
  std::vector<int> part(stress.size(), 0);
  for (std::size_t k = first; k <= last; ++k) {
    part[k] = static_cast<int>((k - first) * parts / (last + 1 - first));
    rows.push_back(k);
  }
  const auto slope = [&](const statistics::Items& some) {
    const auto of = [&](const Values& v) { return mapped(some, [&](std::size_t k) { return v[k]; }); };
    return Values{statistics::fit_line(of(strain), of(stress)).slope};
  };
  if (rows.size() < 2 * parts) return {slope(rows).front(), statistics::unknown};
  return statistics::jackknife(rows, part, slope).front();
}

std::size_t first_above(const Values& stress, double level) {
  return static_cast<std::size_t>(std::ranges::find_if(stress, [&](double v) { return v >= level; }) - stress.begin());
}

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

bool is_oedometric(const TestCurves& curves) {
  for (std::size_t k = 0; k < curves.strain.size(); ++k)
    if (!(std::abs(curves.volume[k] - curves.strain[k]) <= 1e-9)) return false;
  return !curves.sheared && curves.confined;
}

std::optional<OedometerTest> oedometer_test(const Test& test, const TestCurves& curves) {
  const auto loading = loading_of(test);
  if (!loading || !is_oedometric(curves) || !loading->curves.has("sigma_xx") || !loading->curves.has("sigma_yy"))
    return {};
  const Values &along = loading->curves[loading->upright ? "sigma_yy" : "sigma_xx"],
               &across = loading->curves[loading->upright ? "sigma_xx" : "sigma_yy"];
  const auto most = static_cast<std::size_t>(std::ranges::max_element(along) - along.begin());
  if (!(along[most] > 0) || !(along.back() > 0)) return {};
  return OedometerTest{along.back(), curves.strain.back(), across.back() / along.back(),
                       slope_between(curves.strain, along, first_above(along, 0.5 * along[most]), most)};
}

}  // namespace arenite::fields
