#include "thermal/identify/curve.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/median.hpp"
#include "core/option.hpp"
#include "statistics/correlation.hpp"

namespace arenite::identify {
namespace {

constexpr double noise_share = 0.05;  // of the range: smaller changes are no turning points
constexpr std::size_t fewest_points = 5;

/// A turning point of the force.
struct Turn {
  std::size_t at = 0;
  bool peak = false;
};

/// The force with compression positive.
std::vector<double> upright(const std::vector<double>& force) {
  const auto [low, high] = std::minmax_element(force.begin(), force.end());
  return mapped(force, [sign = -*low > *high ? -1 : 1](double v) { return sign * v; });
}

std::vector<Turn> turns_of(const std::vector<double>& f) {
  const auto [low, high] = std::minmax_element(f.begin(), f.end());
  const double least = noise_share * (*high - *low);
  std::vector<Turn> turns;
  std::size_t extreme = 0;
  bool rising = true;
  for (std::size_t k = 0; k < f.size(); ++k) {
    if (rising ? f[k] > f[extreme] : f[k] < f[extreme]) extreme = k;
    else if (k > 0 && std::abs(f[k] - f[extreme]) > least) {
      turns.push_back({extreme, rising});
      rising = !rising;
      extreme = k;
    }
  }
  turns.push_back({extreme, rising});
  if (turns.front().peak && turns.front().at > 0) turns.insert(turns.begin(), Turn{0, false});
  return turns;
}

[[noreturn]] void refuse(const Curve& curve, std::size_t at, const std::string& what) {
  throw InputError(curve.file, curve.line.empty() ? 0 : curve.line[at],
                   curve.name.empty() ? what : curve.name + ": " + what);
}

/// A force that falls back in between is a slip, or rows in a wrong order, and no cycle of its own.
void check_valleys(const Curve& curve, const std::vector<double>& f, const std::vector<Turn>& turns) {
  for (std::size_t t = 1; t + 1 < turns.size(); ++t) {
    if (turns[t].peak) continue;
    const double lesser = std::min(f[turns[t - 1].at], f[turns[t + 1].at]);
    if (f[turns[t].at] > 0.5 * lesser)
      refuse(curve, turns[t].at,
             fmt::format("the force falls from {:.4g} to {:.4g} N and rises again; a loading must rise steadily: "
                         "remove the rows where the specimen slipped, or sort the rows by time",
                         f[turns[t - 1].at], f[turns[t].at]));
  }
}

/// Noise of one point, from what neighbours' steps differ by; a slip or two do not change it.
double noise_of(const std::vector<double>& x) {
  std::vector<double> bends;
  for (std::size_t k = 2; k < x.size(); ++k) bends.push_back(std::abs(x[k] - 2 * x[k - 1] + x[k - 2]));
  return median(std::move(bends)) / (0.6745 * std::sqrt(6.0));
}

/// The displacement must go one way, but for noise.
void check_displacement(const Curve& curve, const std::vector<std::size_t>& points,
                        const std::vector<double>& displacement, double sense) {
  double least = sense * displacement[0], most = least, back = 0;
  std::size_t worst = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double moved = sense * displacement[k];
    most = std::max(most, moved), least = std::min(least, moved);
    if (most - moved > back) back = most - moved, worst = k;
  }
  if (back > noise_share * (most - least) &&
      back > 8 * noise_of(displacement))  // noise alone reaches about 7 standard deviations from end to end
    refuse(curve, points[worst],
           fmt::format("the displacement reverses by {:.3g} mm while the force continues; check that force and "
                       "displacement are the right columns, or remove the rows of the slip",
                       1e3 * back));
}

Cycle cycle_between(const Curve& curve, const std::vector<double>& f, std::size_t first, std::size_t last,
                    const StiffnessOptions& options) {
  Cycle cycle{first, last, std::max(f[first], f[last]), {}, {}};
  std::vector<std::size_t> points;
  for (std::size_t k = first; k <= last; ++k)
    if (f[k] > options.preload) points.push_back(k);
  if (points.size() < fewest_points)
    refuse(curve, last,
           fmt::format("a cycle has {} points beyond the preload of {:.4g} N; a slope needs at least {}: record more "
                       "often, or lower the preload with {}",
                       points.size(), options.preload, fewest_points, option("preload")));
  const auto displacement = mapped(points, [&](std::size_t k) { return curve.x[k]; });
  const Regression line = regress(mapped(points, [&](std::size_t k) { return f[k]; }), displacement);
  const auto [least, most] = std::minmax_element(displacement.begin(), displacement.end());
  const auto range = statistics::confidence_95(line.slope);
  if (*least == *most || !(range.low > 0 || range.high < 0))
    refuse(curve, last,
           "the displacement does not change with the force beyond its noise; check that it is the right column");
  check_displacement(curve, points, displacement,
                     (options.branch == Branch::loading) == (line.slope.value > 0) ? 1 : -1);
  const statistics::Measured compliance{std::abs(line.slope.value), line.slope.error, line.slope.freedom};
  cycle.stiffness = statistics::product({{compliance, -1}});
  cycle.r2 = line.r2;
  return cycle;
}

double squares_of(const std::vector<double>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

constexpr std::ptrdiff_t points_before = 10, fewest_before = 5;

/// Scatter of the points up to the peak about their straight line, the peak left out: it was chosen for being high.
statistics::Measured peak_with_noise(const Curve& curve, std::ptrdiff_t peak) {
  const double value = curve.y[static_cast<std::size_t>(peak)];
  const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, peak - points_before), count = peak - first;
  if (count < fewest_before) return {value};
  const std::vector<double> x(curve.x.begin() + first, curve.x.begin() + peak),
      y(curve.y.begin() + first, curve.y.begin() + peak);
  const auto m = statistics::second_moments(x, y);
  if (!(m.xx > 0)) return {value};
  const double freedom = static_cast<double>(count - 2);
  return {value, std::sqrt(std::max(0.0, m.yy - m.xy * m.xy / m.xx) / freedom), freedom};
}

constexpr std::size_t enough_for_correlation = 10;

/// Correlation of neighbouring residuals, 0 to 0.99. What n residuals of a fit show falls short of the noise's by
/// about (1 + 4 r)/n (Marriott and Pope 1954), which is put back.
double neighbour_correlation(const std::vector<double>& residuals) {
  if (residuals.size() < enough_for_correlation) return 0;
  const double products = std::inner_product(residuals.begin() + 1, residuals.end(), residuals.begin(), 0.0),
               squares = squares_of(residuals);
  if (!(squares > 0)) return 0;
  const double n = static_cast<double>(residuals.size()), seen = products / squares;
  if (seen * std::sqrt(n) < 1.645) return 0;  // white noise shows as much in 1 of 20 cases
  return std::clamp(seen + (1 + 4 * seen) / n, 0.0, 0.99);
}

}  // namespace

std::vector<Cycle> cycles_of(const Curve& curve, const StiffnessOptions& options) {
  if (curve.x.empty()) throw InputError(curve.file, 0, "holds no points; give one row per point");
  const std::vector<double> f = upright(curve.y);
  const auto greatest = std::max_element(f.begin(), f.end());
  if (*greatest <= options.preload)
    refuse(curve, static_cast<std::size_t>(greatest - f.begin()),
           fmt::format("the force never exceeds the preload of {:.4g} N, its maximum is {:.4g} N; give the test's own "
                       "preload with {}",
                       options.preload, *greatest, option("preload")));
  const std::vector<Turn> turns = turns_of(f);
  check_valleys(curve, f, turns);
  std::vector<Cycle> cycles;
  for (std::size_t t = 0; t + 1 < turns.size(); ++t) {
    if (turns[t].peak == (options.branch == Branch::loading)) continue;
    if (std::max(f[turns[t].at], f[turns[t + 1].at]) <= options.preload) continue;
    cycles.push_back(cycle_between(curve, f, turns[t].at, turns[t + 1].at, options));
  }
  if (cycles.empty())
    refuse(curve, curve.x.size() - 1,
           options.branch == Branch::loading
               ? "the force never rises; give the loading, or " + option("branch") + " unloading"
               : "the force never falls; give the unloading, or " + option("branch") + " loading");
  return cycles;
}

PullOff pull_off(const Curve& curve) {
  if (curve.y.size() < 3) refuse(curve, 0, "a pull-off record needs at least three points; give the whole record");
  const auto at = std::max_element(curve.y.begin(), curve.y.end());
  const std::ptrdiff_t peak = at - curve.y.begin();
  if (!(*at > 0))
    refuse(curve, static_cast<std::size_t>(peak), "the force is never a tension; write tension as positive force");
  PullOff result{peak_with_noise(curve, peak), false};
  result.separated = std::any_of(at, curve.y.end(), [&](double force) { return force <= 0.5 * *at; });
  return result;
}

Regression regress(const std::vector<double>& x, const std::vector<double>& y, bool through_origin) {
  const std::size_t unknowns = through_origin ? 1 : 2;
  if (x.size() <= unknowns) return {};
  const double n = static_cast<double>(x.size());
  auto m = statistics::second_moments(x, y);
  if (through_origin) {
    m.xx += n * m.mean_x * m.mean_x, m.xy += n * m.mean_x * m.mean_y, m.yy += n * m.mean_y * m.mean_y;
    m.mean_x = m.mean_y = 0;
  }
  if (!(m.xx > 0)) return {};
  const double slope = m.xy / m.xx, intercept = m.mean_y - slope * m.mean_x;
  std::vector<double> residuals;
  for (std::size_t k = 0; k < x.size(); ++k) residuals.push_back(y[k] - intercept - slope * x[k]);
  const double squares = squares_of(residuals);
  Regression r;
  r.correlation = neighbour_correlation(residuals);
  const double widening = (1 + r.correlation) / (1 - r.correlation);
  const double freedom = std::max(1.0, n / widening - static_cast<double>(unknowns));
  const double variance = squares / (n - static_cast<double>(unknowns)) * widening;
  r.slope = {slope, std::sqrt(variance / m.xx), freedom};
  r.intercept = through_origin ? statistics::Measured{0}
                               : statistics::Measured{
                                     intercept, std::sqrt(variance * (1 / n + m.mean_x * m.mean_x / m.xx)), freedom};
  if (m.yy > 0) r.r2 = 1 - squares / m.yy;
  return r;
}

}  // namespace arenite::identify
