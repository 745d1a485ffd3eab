#include "statistics/line.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::statistics {

Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  if (x.size() < 3) return {};
  double mx = 0, my = 0, xx = 0, xy = 0, yy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    mx += x[k] / n;
    my += y[k] / n;
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mx) * (x[k] - mx);
    xy += (x[k] - mx) * (y[k] - my);
    yy += (y[k] - my) * (y[k] - my);
  }
  if (xx <= 0 || yy <= 0) return {};
  const double slope = xy / xx, residual = std::max(0.0, yy - slope * xy);
  const double variance = residual / (n - 2);
  return {slope, std::sqrt(variance / xx), 1 - residual / yy, my - slope * mx, std::sqrt(variance * (1 / n + mx * mx / xx))};
}

}  // namespace arenite::statistics
