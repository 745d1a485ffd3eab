#include "statistics/exponential_tail.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "statistics/line.hpp"

namespace arenite::statistics {
namespace {

/// Vuong's comparison of two fits of the excesses y > 0: exponential of rate beta, half-Gaussian of the same data.
void compare_with_half_gaussian(const std::vector<double>& y, double beta, ExponentialTail& tail) {
  double variance = 0;
  const double n = static_cast<double>(y.size());
  for (const double v : y) variance += v * v / n;
  double sum = 0, squares = 0;
  for (const double v : y) {
    const double lead = (std::log(beta) - beta * v) - (0.5 * std::log(2 / (std::numbers::pi * variance)) - v * v / (2 * variance));
    sum += lead;
    squares += lead * lead;
  }
  const double spread = std::sqrt(std::max(0.0, squares - sum * sum / n));
  tail.likelihood_ratio = sum;
  if (spread > 0) tail.p_value = 0.5 * std::erfc(sum / spread / std::numbers::sqrt2);
}

}  // namespace

ExponentialTail exponential_tail(const std::vector<double>& sorted) {
  ExponentialTail tail;
  const auto first = std::upper_bound(sorted.begin(), sorted.end(), 1.0);
  std::vector<double> excess, logarithm;
  double sum = 0;
  const double n = static_cast<double>(sorted.size());
  for (auto it = first; it != sorted.end(); ++it) {
    excess.push_back(*it - 1);
    logarithm.push_back(std::log((static_cast<double>(sorted.end() - it) - 0.5) / n));
    sum += excess.back();
  }
  tail.count = excess.size();
  if (tail.count < 2) return tail;
  const double count = static_cast<double>(tail.count), beta = count / sum;
  tail.beta = {beta, beta / std::sqrt(count)};
  const Line line = fit_line(excess, logarithm);
  tail.line_beta = {-line.slope, line.slope_error};
  tail.line_r2 = line.r2;
  compare_with_half_gaussian(excess, beta, tail);
  return tail;
}

}  // namespace arenite::statistics
