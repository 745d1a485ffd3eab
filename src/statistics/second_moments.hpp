#pragma once
#include <cstddef>
#include <vector>

namespace arenite::statistics {

/// Means of x and y, and sums of squares and products about them.
struct SecondMoments {
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, yy = 0;
};

inline SecondMoments second_moments(const std::vector<double>& x, const std::vector<double>& y) {
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

}  // namespace arenite::statistics
