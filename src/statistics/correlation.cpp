#include "statistics/correlation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
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
  return {slope, std::sqrt(variance / xx), 1 - residual / yy, my - slope * mx, std::sqrt(variance * (1 / n + mx * mx / xx))};
}

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
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
    throw InputError(fmt::format("a correlation of {} values with {} has no pairs; give as many of one as of the other", x.size(), y.size()));
  std::vector<double> a, b;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (std::isfinite(x[k]) && std::isfinite(y[k])) {
      a.push_back(x[k]);
      b.push_back(y[k]);
    }
  Relation relation;
  relation.count = a.size();
  relation.line = fit_line(a, b);
  std::vector<std::vector<double>> replicates;
  for (std::size_t k = 0; k < a.size() && a.size() > 2; ++k) {
    std::vector<double> p = a, q = b;
    p.erase(p.begin() + static_cast<std::ptrdiff_t>(k));
    q.erase(q.begin() + static_cast<std::ptrdiff_t>(k));
    replicates.push_back({pearson(p, q), spearman(p, q)});
  }
  const auto e = with_errors({pearson(a, b), spearman(a, b)}, replicates);
  relation.pearson = e[0];
  relation.spearman = e[1];
  return relation;
}

}  // namespace arenite::statistics
