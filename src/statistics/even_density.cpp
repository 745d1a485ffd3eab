#include "statistics/even_density.hpp"

#include <algorithm>

namespace arenite::statistics {

EvenDensity even_density(const std::vector<double>& x, double factor) {
  EvenDensity result{{-1, 0.05, 140}, {}};
  const Bins& bins = result.bins;
  std::vector<std::size_t> in(bins.count, 0);
  const double scale = factor / bins.width, shift = bins.low / bins.width, end = static_cast<double>(bins.count);
  for (const double value : x) {
    const double at = value * scale - shift;
    if (at >= 0 && at < end) ++in[static_cast<std::size_t>(at)];
  }
  for (const std::size_t n : in) result.density.push_back(static_cast<double>(n) / (static_cast<double>(x.size()) * bins.width));
  return result;
}

std::vector<double> smoothed(const std::vector<double>& f) {
  std::vector<double> smooth;
  for (std::size_t k = 0; k < f.size(); ++k) {
    const std::size_t from = k > 0 ? k - 1 : 0, to = std::min(k + 2, f.size());
    double sum = 0;
    for (std::size_t j = from; j < to; ++j) sum += f[j];
    smooth.push_back(sum / static_cast<double>(to - from));
  }
  return smooth;
}

Peak peak_of(const Bins& bins, const Counts& counts) {
  Peak peak;
  const std::vector<double> f = smoothed(density(bins, counts));
  for (std::size_t k = 0; k < f.size(); ++k)
    if (!(f[k] <= peak.height)) peak = {bins.centre(k), f[k]};
  return peak;
}

}  // namespace arenite::statistics
