#include "statistics/line.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/second_moments.hpp"

namespace arenite::statistics {

Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  if (x.size() < 3) return {};
  const auto [mx, my, xx, xy, yy] = second_moments(x, y);
  if (xx <= 0 || yy <= 0) return {};
  const double slope = xy / xx, residual = std::max(0.0, yy - slope * xy);
  const double variance = residual / (n - 2);
  return {slope, std::sqrt(variance / xx), 1 - residual / yy, my - slope * mx, std::sqrt(variance * (1 / n + mx * mx / xx))};
}

}  // namespace arenite::statistics
