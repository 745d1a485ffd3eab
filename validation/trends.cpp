#include "validation/trends.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "statistics/correlation.hpp"

namespace arenite::validation {
namespace {

std::pair<std::vector<double>, std::vector<double>> columns(const Series& points) {
  std::pair<std::vector<double>, std::vector<double>> xy;
  for (const Point& p : points) {
    xy.first.push_back(p.x);
    xy.second.push_back(p.mean);
  }
  return xy;
}

}  // namespace

Value value_of(const Point& point) {
  if (std::isfinite(point.freedom)) return {point.mean, point.error, point.freedom};
  return {point.mean, point.error, point.runs > 0 ? static_cast<double>(point.runs) - 1 : statistics::unknown};
}

Value rise(const Series& points) {
  if (points.size() < 2) return {};
  return difference(value_of(points.back()), value_of(points.front()));
}

Value slope(const Series& points) {
  if (points.size() < 2) return {};
  double mean_x = 0, sxx = 0;
  for (const Point& p : points) mean_x += p.x / static_cast<double>(points.size());
  for (const Point& p : points) sxx += (p.x - mean_x) * (p.x - mean_x);
  std::vector<std::pair<double, Value>> terms;
  double pooled = 0;
  for (const Point& p : points) {
    terms.emplace_back((p.x - mean_x) / sxx, value_of(p));
    if (std::isfinite(p.freedom)) pooled = std::max(pooled, p.freedom);
  }
  Value by_means = weighted_sum(terms);
  if (pooled > 0) by_means.freedom = std::min(by_means.freedom, pooled);  // one variance, counted once
  if (std::isfinite(by_means.error)) return by_means;
  const auto [x, y] = columns(points);
  const auto line = statistics::fit_line(x, y);
  return {line.slope, line.slope_error, static_cast<double>(points.size()) - 2};
}

double line_r2(const Series& points) {
  const auto [x, y] = columns(points);
  return statistics::fit_line(x, y).r2;
}

double spearman(const Series& points) {
  const auto [x, y] = columns(points);
  return points.size() > 2 ? statistics::spearman(x, y) : statistics::unknown;
}

Family steps(const Series& points) {
  Family all;
  for (std::size_t k = 1; k < points.size(); ++k)
    all.push_back({fmt::format("from {:g} to {:g}", points[k - 1].x, points[k].x),
                   difference(value_of(points[k]), value_of(points[k - 1]))});
  return all;
}

Family leads_of_last(const Series& points) {
  Family all;
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    all.push_back({fmt::format("{:g} minus {:g}", points.back().x, points[k].x),
                   difference(value_of(points.back()), value_of(points[k]))});
  return all;
}

Check monotone(const std::string& what, const std::string& source, const Series& points, int direction) {
  return trend(what, source, slope(points), steps(points), direction);
}

}  // namespace arenite::validation
