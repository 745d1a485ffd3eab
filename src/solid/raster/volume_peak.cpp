#include "solid/raster/volume_peak.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arenite::raster {
namespace {

/// Silverman's rule of thumb for values in rising order.
double kernel_width(const std::vector<double>& sorted) {
  const double n = static_cast<double>(sorted.size());
  double mean = 0, squares = 0;
  for (const double x : sorted) mean += x / n;
  for (const double x : sorted) squares += (x - mean) * (x - mean) / (n - 1);
  const double quarters = sorted[3 * (sorted.size() - 1) / 4] - sorted[(sorted.size() - 1) / 4], deviation = std::sqrt(squares);
  const double spread = quarters > 0 ? std::min(deviation, quarters / 1.34) : deviation;
  return 0.9 * spread * std::pow(n, -0.2);
}

}  // namespace

double density_peak(const std::vector<double>& volumes) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (volumes.size() < 2) return unknown;
  std::vector<double> logarithm;
  for (const double v : volumes) logarithm.push_back(std::log(v));
  std::sort(logarithm.begin(), logarithm.end());
  const double width = kernel_width(logarithm), low = logarithm.front(), high = logarithm.back();
  if (!(width > 0) || !(high > low)) return unknown;
  constexpr int steps = 400;
  double peak = unknown, highest = 0;
  for (int k = 0; k <= steps; ++k) {
    const double at = low + (high - low) * k / steps;
    double density = 0;
    for (const double x : logarithm) density += std::exp(-0.5 * (x - at) * (x - at) / (width * width));
    density *= std::exp(-at);
    if (density > highest) highest = density, peak = std::exp(at);
  }
  return peak;
}

}  // namespace arenite::raster
