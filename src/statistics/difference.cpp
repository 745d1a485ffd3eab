#include "statistics/difference.hpp"

#include <cmath>
#include <numbers>

namespace arenite::statistics {
namespace {

/// Into [-period/2, period/2).
double shorter_way(double angle, double period) {
  const double turned = angle + period / 2;
  return turned - period * std::floor(turned / period) - period / 2;
}

double joined_error(double a, double b) {
  if (std::isnan(a)) return b;
  return std::isnan(b) ? a : std::hypot(a, b);
}

}  // namespace

Difference difference_of(const Estimate& a, const Estimate& b, double period) {
  Difference d;
  d.value = period > 0 ? shorter_way(b.value - a.value, period) : b.value - a.value;
  d.error = joined_error(a.error, b.error);
  if (std::isnan(a.value) || std::isnan(b.value)) return d;
  if (d.error > 0) d.in_errors = d.value / d.error;
  if (a.value == b.value) d.verdict = Verdict::equal;
  else if (!(d.error > 0)) d.verdict = Verdict::unjudged;
  else d.verdict = std::abs(d.value) > least_told * d.error ? Verdict::beyond : Verdict::within;
  return d;
}

Estimate inverse_of(const Estimate& a, double over) {
  return {over / a.value, std::abs(over) * a.error / (a.value * a.value)};
}

double beyond_by_chance(std::size_t judged) {
  return std::erfc(least_told / std::numbers::sqrt2) * static_cast<double>(judged);
}

}  // namespace arenite::statistics
