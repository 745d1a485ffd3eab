#include "validation/claims/tail_growth.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace arenite::validation {
namespace {

/// S_m and the slope of the tail of one sample, rising in S_m.
using GrowthCurve = std::vector<std::pair<double, double>>;

/// Of every seed by gamma. Samples of different gamma are counted alike: each has a packing of its own.
std::map<double, std::vector<GrowthCurve>> growth_curves(const Samples& samples, const std::string& set) {
  std::map<double, std::map<std::string, GrowthCurve>> found;
  for (const Run& run : samples.runs) {
    const double saturation = run("S_m"), tail = run("stress." + samples.component + ".sets." + set + ".tail.slope");
    if (theta_of(run) == 1.4 && cement_of(run) != full && std::isfinite(saturation * tail))
      found[gamma_of(run)][run.text("seed")].emplace_back(saturation, tail);
  }
  std::map<double, std::vector<GrowthCurve>> all;
  for (auto& [gamma, seeds] : found)
    for (auto& [seed, curve] : seeds) {
      std::sort(curve.begin(), curve.end());
      if (curve.size() > 1) all[gamma].push_back(curve);
    }
  return all;
}

/// Between the points of a curve that lie next to it; the ends' outside.
double interpolated(const GrowthCurve& curve, double x) {
  const auto next = std::lower_bound(curve.begin(), curve.end(), std::pair(x, -HUGE_VAL));
  if (next == curve.begin()) return next->second;
  if (next == curve.end()) return curve.back().second;
  const auto& [x0, y0] = *(next - 1);
  const auto& [x1, y1] = *next;
  return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
}

/// The greatest least S_m and the least greatest one: what all samples reach.
std::pair<double, double> common_range(const std::map<double, std::vector<GrowthCurve>>& all) {
  double low = -HUGE_VAL, high = HUGE_VAL;
  for (const auto& [gamma, some] : all)
    for (const GrowthCurve& curve : some) {
      low = std::max(low, curve.front().first);
      high = std::min(high, curve.back().first);
    }
  return {low, high};
}

}  // namespace

Value growth_of_effect(const Samples& samples, const std::string& set) {
  const auto all = growth_curves(samples, set);
  const auto [low, high] = common_range(all);
  if (all.size() < 2 || !(low < high)) return {};
  Series changes;
  for (const auto& [gamma, some] : all) {
    std::vector<double> values;
    for (const GrowthCurve& curve : some) values.push_back(interpolated(curve, high) - interpolated(curve, low));
    const Value mean = statistics::mean_of(values);
    changes.push_back({gamma, mean.value, mean.error, values.size()});
  }
  return slope(changes);
}

}  // namespace arenite::validation
