#include "statistics/correlation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::statistics {

SecondMoments second_moments(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  SecondMoments m;
  for (std::size_t k = 0; k < x.size(); ++k) {
    m.mean_x += x[k] / n;
    m.mean_y += y[k] / n;
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    m.xx += (x[k] - m.mean_x) * (x[k] - m.mean_x);
    m.xy += (x[k] - m.mean_x) * (y[k] - m.mean_y);
    m.yy += (y[k] - m.mean_y) * (y[k] - m.mean_y);
  }
  return m;
}

Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  if (x.size() < 3) return {};
  const auto [mx, my, xx, xy, yy] = second_moments(x, y);
  if (xx <= 0 || yy <= 0) return {};
  const double slope = xy / xx, residual = std::max(0.0, yy - slope * xy);
  const double variance = residual / (n - 2);
  return {slope, std::sqrt(variance / xx), 1 - residual / yy, my - slope * mx,
          std::sqrt(variance * (1 / n + mx * mx / xx))};
}

std::vector<double> ranks(const std::vector<double>& values) {
  const auto order = ordered_by(values.size(), [&](std::size_t i) { return values[i]; });
  std::vector<double> rank(values.size());
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && values[order[last]] == values[order[first]]) ++last;
    for (std::size_t k = first; k < last; ++k) rank[order[k]] = 0.5 * static_cast<double>(first + 1 + last);
  }
  return rank;
}

double mean_of_known(const std::vector<double>& values, const std::vector<std::uint8_t>& counts) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (std::isfinite(values[k]) && (counts.empty() || counts[k])) sum += values[k], ++count;
  return count > 0 ? sum / count : unknown;
}

std::vector<double> over(std::vector<double> values, double mean) {
  for (double& value : values) value = mean != 0 ? value / mean : unknown;
  return values;
}

std::vector<double> over_mean(const std::vector<double>& values) { return over(values, mean_of_known(values)); }

double rms_difference(const std::vector<double>& x, const std::vector<double>& y) {
  double squares = 0;
  for (std::size_t k = 0; k < x.size(); ++k) squares += (x[k] - y[k]) * (x[k] - y[k]);
  return std::sqrt(squares / static_cast<double>(x.size()));
}

double pearson(const std::vector<double>& x, const std::vector<double>& y) {
  const SecondMoments m = second_moments(x, y);
  return m.xx > 0 && m.yy > 0 ? m.xy / std::sqrt(m.xx * m.yy) : unknown;
}

double spearman(const std::vector<double>& x, const std::vector<double>& y) { return pearson(ranks(x), ranks(y)); }

Relation relate(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() != y.size())
    throw refusal("a correlation of {} values with {} has no pairs; give as many of one as of the other", x.size(),
                  y.size());
  Items known;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (std::isfinite(x[k]) && std::isfinite(y[k])) known.push_back(k);
  std::vector<int> own(x.size());  // each a block of its own
  std::iota(own.begin(), own.end(), 0);
  const auto of = [](const Items& rows, const std::vector<double>& values) {
    return mapped(rows, [&](std::size_t k) { return values[k]; });
  };
  const auto e = jackknife(known, own, [&](const Items& rows) {
    const auto p = of(rows, x), q = of(rows, y);
    return std::vector<double>{pearson(p, q), spearman(p, q)};
  });
  return {known.size(), e[0], e[1], fit_line(of(known, x), of(known, y))};
}

}  // namespace arenite::statistics
