#include "statistics/cut_laws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arenite::statistics {

double cut_exponential_rate(double mean, double length) {
  // The mean over the length falls from 1 to 0 as a = s length rises.
  const auto relative_mean = [](double a) { return std::abs(a) < 1e-4 ? 0.5 - a / 12 : 1 / a - 1 / std::expm1(a); };
  const double target = mean / length;
  double low = -1, high = 1;
  while (relative_mean(low) < target && low > -1e9) low *= 2;
  while (relative_mean(high) > target && high < 1e9) high *= 2;
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (relative_mean(middle) > target ? low : high) = middle;
  }
  return 0.5 * (low + high) / length;
}

double log_integral_exponential(double s, double length) {
  const double a = s * length;
  if (std::abs(a) < 1e-8) return std::log(length);
  return std::log(length) + (a > 0 ? std::log(-std::expm1(-a) / a) : -a + std::log(std::expm1(a) / a));
}

double log_integral_gaussian(double theta, double a, double b) {
  if (theta * std::max(a * a, b * b) < 1e-8) return std::log(b - a);
  const double root = std::sqrt(theta);
  return std::log(0.5 * std::sqrt(std::numbers::pi) / root * (std::erfc(a * root) - std::erfc(b * root)));
}

double cut_gaussian_rate(double mean_square, double a, double b) {
  // Likelihood a value; concave in theta. Its upper end keeps the integral above the smallest numbers.
  const auto likelihood = [&](double theta) { return -theta * mean_square - log_integral_gaussian(theta, a, b); };
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double low = 0, high = a > 0 ? 500 / (a * a) : 100 / mean_square;
  for (int k = 0; k < 100; ++k) {
    const double span = golden * (high - low), left = high - span, right = low + span;
    if (likelihood(left) < likelihood(right))
      low = left;
    else
      high = right;
  }
  return 0.5 * (low + high);
}

}  // namespace arenite::statistics
