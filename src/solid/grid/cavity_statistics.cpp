#include "solid/grid/cavity_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "solid/grid/cavities.hpp"

namespace arenite::grid {
namespace {

/// Edges in nodes, half-way between whole numbers, each once.
std::vector<double> edges_in_nodes(std::int64_t least, std::int64_t most) {
  constexpr int bins = 30;
  const double low = static_cast<double>(least) - 0.5, high = static_cast<double>(most) + 0.5;
  std::vector<double> edge{low};
  for (int k = 1; k < bins; ++k) {
    const double half = std::floor(low * std::pow(high / low, static_cast<double>(k) / bins)) + 0.5;
    if (half > edge.back() && half < high) edge.push_back(half);
  }
  edge.push_back(high);
  return edge;
}

VolumeDensity density_of(const std::vector<std::int64_t>& nodes, double unit) {
  VolumeDensity pdf;
  if (nodes.empty()) return pdf;
  const auto [least, most] = std::minmax_element(nodes.begin(), nodes.end());
  const auto edge = edges_in_nodes(*least, *most);
  pdf.count.assign(edge.size() - 1, 0);
  for (const auto n : nodes) {
    const auto above = std::upper_bound(edge.begin(), edge.end(), static_cast<double>(n));
    ++pdf.count[static_cast<std::size_t>(above - edge.begin()) - 1];
  }
  const double all = static_cast<double>(nodes.size());
  for (const double e : edge) pdf.edge.push_back(e * unit);
  for (std::size_t k = 0; k < pdf.count.size(); ++k) {
    const double n = static_cast<double>(pdf.count[k]), width = pdf.edge[k + 1] - pdf.edge[k];
    pdf.density.push_back(n / (all * width));
    pdf.error.push_back(std::sqrt(n * (1 - n / all)) / (all * width));
  }
  return pdf;
}

void add_moments(const std::vector<std::int64_t>& nodes, double unit, CavityStatistics& s) {
  const double n = static_cast<double>(nodes.size());
  if (nodes.empty()) return;
  double sum = 0, m2 = 0, m3 = 0, m4 = 0;
  for (const auto v : nodes) sum += static_cast<double>(v);
  const double mean = sum / n;
  for (const auto v : nodes) {
    const double d = static_cast<double>(v) - mean;
    m2 += d * d, m3 += d * d * d, m4 += d * d * d * d;
  }
  m2 /= n, m3 /= n, m4 /= n;
  s.mean.value = mean * unit;
  if (nodes.size() < 2 || m2 == 0) return;
  const double deviation = std::sqrt(m2 * n / (n - 1));
  s.deviation.value = deviation * unit;
  s.cv.value = deviation / mean;
  s.mean.error = s.deviation.value / std::sqrt(n);
  // Variances of mean and deviation and their covariance to leading order in 1/n; cv by propagation.
  const double variance_mean = m2 / n, variance_deviation = std::max(0.0, (m4 - m2 * m2) / (4 * m2 * n));
  const double covariance = m3 / (2 * deviation * n);
  s.deviation.error = std::sqrt(variance_deviation) * unit;
  const double relative = variance_deviation / m2 + variance_mean / (mean * mean) - 2 * covariance / (deviation * mean);
  s.cv.error = s.cv.value * std::sqrt(std::max(0.0, relative));
}

void add_ranks(const std::vector<std::int64_t>& nodes, double unit, CavityStatistics& s) {
  if (nodes.size() < 2) return;
  auto volume = mapped(nodes, [&](auto v) { return static_cast<double>(v) * unit; });
  std::sort(volume.begin(), volume.end());
  s.tenth = volume[volume.size() / 10];
  s.median = volume[volume.size() / 2];
  const double peak = density_peak(volume);
  if (std::isfinite(peak)) s.peak = peak;
}

/// Silverman's rule of thumb for values in rising order.
double kernel_width(const std::vector<double>& sorted) {
  const double n = static_cast<double>(sorted.size());
  double mean = 0, squares = 0;
  for (const double x : sorted) mean += x / n;
  for (const double x : sorted) squares += (x - mean) * (x - mean) / (n - 1);
  const double quarters = sorted[3 * (sorted.size() - 1) / 4] - sorted[(sorted.size() - 1) / 4],
               deviation = std::sqrt(squares);
  const double spread = quarters > 0 ? std::min(deviation, quarters / 1.34) : deviation;
  return 0.9 * spread * std::pow(n, -0.2);
}

}  // namespace

CavityStatistics cavity_statistics(const Cavities& cavities, double dx, double large_radius) {
  if (!(dx > 0 && large_radius > 0 && std::isfinite(dx) && std::isfinite(large_radius)))
    throw refusal("volumes need a positive node spacing and mean large radius, not {:g} and {:g} m", dx, large_radius);
  CavityStatistics s;
  s.rules = cavities.rules;
  s.count = cavities.nodes.size(), s.specks = cavities.specks, s.cut = cavities.cut;
  const double unit = dx * dx / (std::numbers::pi * large_radius * large_radius);
  add_moments(cavities.nodes, unit, s);
  add_ranks(cavities.nodes, unit, s);
  s.density = density_of(cavities.nodes, unit);
  return s;
}

PhaseFractions phase_fractions(const PhaseMap& map) {
  std::int64_t phase[3] = {0, 0, 0}, of_class[3] = {0, 0, 0};
  for (std::size_t k = 0; k < map.phase.size(); ++k) {
    ++phase[static_cast<int>(map.phase[k])];
    if (map.phase[k] == Phase::particle) ++of_class[static_cast<int>(map.grain_class[map.grain[k]])];
  }
  if (map.phase.empty()) return {};
  const auto share = [&](std::int64_t n) { return static_cast<double>(n) / static_cast<double>(map.phase.size()); };
  PhaseFractions f;
  f.empty = share(phase[0]), f.matrix = share(phase[1]), f.particle = share(phase[2]);
  f.unclassed = share(of_class[0]), f.small = share(of_class[1]), f.large = share(of_class[2]);
  const std::int64_t pores = phase[0] + phase[1];
  f.saturation = pores > 0 ? static_cast<double>(phase[1]) / static_cast<double>(pores) : 0;
  return f;
}

std::array<double, node_kinds.size()> fractions_by_kind(const PhaseMap& map) {
  const PhaseFractions f = phase_fractions(map);
  return {f.empty, f.matrix, f.unclassed, f.small, f.large};
}

double density_peak(const std::vector<double>& volumes) {
  using statistics::unknown;
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

}  // namespace arenite::grid
