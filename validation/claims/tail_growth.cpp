#include "validation/claims/tail_growth.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace arenite::validation {
namespace {

/// S_m and the slope of the tail of one sample, rising in S_m.
using Course = std::vector<std::pair<double, double>>;

/// Of every seed by gamma. Samples of different gamma are counted alike: each has a packing of its own.
std::map<double, std::vector<Course>> courses(const Samples& samples, const std::string& set) {
  std::map<double, std::map<std::string, Course>> found;
  for (const Run& run : samples.runs) {
    const double saturation = run("S_m"), tail = run("stress." + samples.component + ".sets." + set + ".tail.slope");
    if (theta_of(run) == 1.4 && cement_of(run) != full && std::isfinite(saturation * tail))
      found[gamma_of(run)][run.text("seed")].emplace_back(saturation, tail);
  }
  std::map<double, std::vector<Course>> all;
  for (auto& [gamma, seeds] : found)
    for (auto& [seed, course] : seeds) {
      std::sort(course.begin(), course.end());
      if (course.size() > 1) all[gamma].push_back(course);
    }
  return all;
}

/// Between the points of a course that lie next to it; the ends' outside.
double interpolated(const Course& course, double x) {
  const auto next = std::lower_bound(course.begin(), course.end(), std::pair(x, -HUGE_VAL));
  if (next == course.begin()) return next->second;
  if (next == course.end()) return course.back().second;
  const auto& [x0, y0] = *(next - 1);
  const auto& [x1, y1] = *next;
  return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
}

/// The greatest least S_m and the least greatest one: what all samples reach.
std::pair<double, double> common_range(const std::map<double, std::vector<Course>>& all) {
  double low = -HUGE_VAL, high = HUGE_VAL;
  for (const auto& [gamma, some] : all)
    for (const Course& course : some) {
      low = std::max(low, course.front().first);
      high = std::min(high, course.back().first);
    }
  return {low, high};
}

}  // namespace

Value growth_of_effect(const Samples& samples, const std::string& set) {
  const auto all = courses(samples, set);
  const auto [low, high] = common_range(all);
  if (all.size() < 2 || !(low < high)) return {};
  Series changes;
  for (const auto& [gamma, some] : all) {
    std::vector<double> values;
    for (const Course& course : some) values.push_back(interpolated(course, high) - interpolated(course, low));
    const Value mean = statistics::mean_of(values);
    changes.push_back({gamma, mean.value, mean.error, values.size()});
  }
  return slope(changes);
}

}  // namespace arenite::validation
