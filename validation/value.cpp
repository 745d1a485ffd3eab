#include "validation/value.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "statistics/measured.hpp"
#include "statistics/written.hpp"

namespace arenite::validation {
namespace {

constexpr double rounding = 1e-12;  ///< what remains of a difference of numbers of order 1 that are equal

/// Two digits of the error; of a value without one, four of its own.
std::string rounded(double number, double decimals) {
  if (decimals >= 0) return fmt::format("{:.{}f}", number, static_cast<int>(decimals));
  const double unit = std::pow(10, -decimals);
  return fmt::format("{:.0f}", std::round(number / unit) * unit);
}

}  // namespace

Value weighted_sum(const std::vector<std::pair<double, Value>>& terms) {
  Value sum{0, 0};
  double squares = 0, of_freedom = 0;
  for (const auto& [weight, value] : terms) {
    const double square = weight * weight * value.error * value.error;
    sum.value += weight * value.value;
    squares += square;
    of_freedom += square * square / value.freedom;
  }
  sum.error = std::sqrt(squares);
  if (of_freedom > 0) sum.freedom = squares * squares / of_freedom;
  return sum;
}

Value difference(const Value& a, const Value& b) { return weighted_sum({{1, a}, {-1, b}}); }

Value ratio(const Value& a, const Value& b) {
  Value result = weighted_sum({{1 / b.value, a}, {-a.value / (b.value * b.value), b}});
  result.value = a.value / b.value;
  return result;
}

Value size_of(const Value& v) { return {std::abs(v.value), v.error, v.freedom}; }

double half_interval(const Value& v, double side) {
  if (!(v.error > 0)) return v.error;
  return v.freedom > 0 ? v.error * statistics::student_quantile(1 - side, v.freedom) : statistics::unknown;
}

double chance_above(const Value& v, double bound) {
  if (!(v.error >= 0)) return statistics::unknown;
  if (v.error == 0) return v.value > bound ? 0 : 1;
  return 1 - statistics::student_share((v.value - bound) / v.error, v.freedom);
}

double chance_of_zero(const Value& v) {
  if (std::abs(v.value) < rounding) return 1;
  const double above = chance_above(v, 0);
  return 2 * std::min(above, 1 - above);
}

std::string text_of(const Value& v) {
  if (!std::isfinite(v.value)) return "not known";
  if (std::abs(v.value) < rounding && !(v.error >= rounding)) return "0";
  if (!(v.error >= std::max(rounding, 1e-9 * std::abs(v.value)))) return fmt::format("{:.4g}", v.value);
  const int decimals = statistics::decimals_of(v.error);
  return rounded(v.value, decimals) + " +- " + rounded(v.error, decimals);
}

}  // namespace arenite::validation
