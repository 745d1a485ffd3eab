#include "ledger/trends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "statistics/line.hpp"

namespace arenite::ledger {
namespace {

Holds known(bool is_known, bool holds) { return !is_known ? Holds::unknown : holds ? Holds::yes : Holds::no; }

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<double> rank;
  for (const double value : values) {
    double below = 0, equal = 0;
    for (const double other : values) {
      below += other < value;
      equal += other == value;
    }
    rank.push_back(below + (equal + 1) / 2);
  }
  return rank;
}

std::pair<std::vector<double>, std::vector<double>> columns(const Series& points) {
  std::pair<std::vector<double>, std::vector<double>> xy;
  for (const Point& p : points) {
    xy.first.push_back(p.x);
    xy.second.push_back(p.mean);
  }
  return xy;
}

Check check(std::string what, std::string source, const Value& ours, std::string tolerance, std::string unit, Holds holds) {
  return {std::move(what), std::move(source), std::move(unit), std::move(tolerance), ours.value, ours.error, holds};
}

}  // namespace

Value difference(const Value& a, const Value& b) { return {a.value - b.value, std::hypot(a.error, b.error)}; }

Value ratio(const Value& a, const Value& b) {
  const double value = a.value / b.value;
  return {value, std::abs(value) * std::hypot(a.error / a.value, b.error / b.value)};
}

Value rise(const Series& points) {
  if (points.size() < 2) return {};
  return difference({points.back().mean, points.back().error}, {points.front().mean, points.front().error});
}

Value slope(const Series& points) {
  if (points.size() < 2) return {};
  double mean_x = 0, sxx = 0, sxy = 0, square = 0;
  for (const Point& p : points) mean_x += p.x / static_cast<double>(points.size());
  for (const Point& p : points) {
    sxx += (p.x - mean_x) * (p.x - mean_x);
    sxy += (p.x - mean_x) * p.mean;
    square += (p.x - mean_x) * (p.x - mean_x) * p.error * p.error;
  }
  if (std::isfinite(square)) return {sxy / sxx, std::sqrt(square) / sxx};
  const auto [x, y] = columns(points);
  const auto line = statistics::fit_line(x, y);
  return {line.slope, line.slope_error};
}

double line_r2(const Series& points) {
  const auto [x, y] = columns(points);
  return statistics::fit_line(x, y).r2;
}

double spearman(const Series& points) {
  const auto [x, y] = columns(points);
  const auto line = statistics::fit_line(ranks(x), ranks(y));
  return std::copysign(std::sqrt(line.r2), line.slope);
}

Check within(std::string what, const Value& ours, double source, double tolerance, std::string unit) {
  return check(std::move(what), fmt::format("{:.4g}", source), ours, fmt::format("+- {:.3g}", tolerance), std::move(unit),
               known(std::isfinite(ours.value), std::abs(ours.value - source) <= tolerance));
}

Check between(std::string what, std::string source, const Value& ours, double low, double high, std::string unit) {
  return check(std::move(what), std::move(source), ours, fmt::format("{:.4g} to {:.4g}", low, high), std::move(unit),
               known(std::isfinite(ours.value), low <= ours.value && ours.value <= high));
}

Check above(std::string what, std::string source, const Value& ours, double bound, std::string unit) {
  return check(std::move(what), std::move(source), ours, fmt::format("> {:.4g}", bound), std::move(unit), known(std::isfinite(ours.value), ours.value > bound));
}

Check below(std::string what, std::string source, const Value& ours, double bound, std::string unit) {
  return check(std::move(what), std::move(source), ours, fmt::format("< {:.4g}", bound), std::move(unit), known(std::isfinite(ours.value), ours.value < bound));
}

Check positive(std::string what, std::string source, const Value& ours, std::string unit) {
  return check(std::move(what), std::move(source), ours, "> 0 by 2 s.e.", std::move(unit),
               known(std::isfinite(ours.value) && std::isfinite(ours.error), ours.value > beyond * ours.error));
}

Check negative(std::string what, std::string source, const Value& ours, std::string unit) {
  return check(std::move(what), std::move(source), ours, "< 0 by 2 s.e.", std::move(unit),
               known(std::isfinite(ours.value) && std::isfinite(ours.error), ours.value < -beyond * ours.error));
}

Check none(std::string what, std::string source, const Value& ours, std::string unit) {
  return check(std::move(what), std::move(source), ours, "0 within 2 s.e.", std::move(unit),
               known(std::isfinite(ours.value) && std::isfinite(ours.error), std::abs(ours.value) <= beyond * ours.error));
}

std::string text_of(const Value& v) {
  if (!std::isfinite(v.value)) return "not known";
  return std::isfinite(v.error) ? fmt::format("{:.4g} +- {:.2g}", v.value, v.error) : fmt::format("{:.4g}", v.value);
}

std::string told(const std::string& who, const Verdict& verdict) {
  std::string text;
  for (const Check& check : verdict.checks)
    if (check.holds != Holds::unknown) text += fmt::format("{} {} {} ({})", text.empty() ? who + ":" : ";", check.what, text_of({check.ours, check.error}), word_for(check.holds));
  return text.empty() ? text : text + ".";
}

}  // namespace arenite::ledger
