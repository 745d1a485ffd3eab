#include "statistics/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/mapped.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::statistics {

double total(const Counts& counts) { return std::accumulate(counts.begin(), counts.end(), 0.0); }

Counts BlockCounts::without(std::size_t b) const {
  Counts rest = all;
  for (std::size_t k = 0; k < rest.size(); ++k) rest[k] -= block[b][k];
  return rest;
}

Bins pdf_bins(std::size_t n, const Spread& s) {
  const double range = s.high - s.low, core = 5.5 * (s.upper_quarter - s.lower_quarter);
  if (!(range > 1e-12 * std::max(std::abs(s.minimum), std::abs(s.maximum)))) return {};
  const double number = std::clamp(std::round(0.8 * std::pow(static_cast<double>(n), 0.4)), 10.0, 200.0);
  const double width = std::max((core > 0 ? std::min(range, core) : range) / number, range / 1000);
  const double first = std::floor(std::max(s.minimum, s.low - 2 * range) / width);
  const double last = std::floor(std::min(s.maximum, s.high + 2 * range) / width) + 1;
  return {first * width, width, static_cast<std::size_t>(last - first)};
}

BlockCounts count(const BlockedSample& sample, const Bins& bins) {
  const Counts none(bins.count + 2, 0.0);
  BlockCounts result{bins, none, std::vector<Counts>(static_cast<std::size_t>(sample.blocks), none)};
  const double scale = bins.count ? 1 / bins.width : 0, top = static_cast<double>(bins.count);
  for (std::size_t i = 0; i < sample.x.size(); ++i) {
    const double k = std::clamp((sample.x[i] - bins.low) * scale, -1.0, top);
    ++result.block[sample.block[i]][static_cast<std::size_t>(k + 1)];
  }
  for (const Counts& block : result.block)
    for (std::size_t k = 0; k < block.size(); ++k) result.all[k] += block[k];
  return result;
}

double survival(const Bins& bins, const Counts& counts, double x) {
  const double place = (x - bins.low) / bins.width;
  double above = counts.back();
  for (std::size_t k = bins.count; k > 0; --k) {
    const double part = static_cast<double>(k) - place;
    if (part <= 0) break;
    above += std::min(part, 1.0) * counts[k];
  }
  return above / total(counts);
}

double quantile(const Bins& bins, const Counts& counts, double p) {
  double rest = p * total(counts) - counts.front();
  for (std::size_t k = 0; k < bins.count; ++k) {
    const double here = counts[k + 1];
    if (rest <= here && here > 0) return bins.edge(k) + std::max(0.0, rest / here) * bins.width;
    rest -= here;
  }
  return bins.edge(bins.count);
}

std::vector<double> density(const Bins& bins, const Counts& counts) {
  const double scale = 1 / (total(counts) * bins.width);
  std::vector<double> of_bins(bins.count);
  for (std::size_t k = 0; k < bins.count; ++k) of_bins[k] = counts[k + 1] * scale;
  return of_bins;
}

Curve pdf(const BlockCounts& counts) {
  Curve curve;
  if (counts.bins.count == 0) return curve;
  const std::vector<double> y = density(counts.bins, counts.all);
  std::vector<std::vector<double>> replicates;
  for (std::size_t b = 0; b < counts.block.size(); ++b)
    if (const Counts rest = counts.without(b); total(rest) > 0) replicates.push_back(density(counts.bins, rest));
  const auto estimates = with_errors(y, replicates);
  for (std::size_t k = 0; k < y.size(); ++k) curve.x.push_back(counts.bins.centre(k));
  curve.y = y;
  curve.error = mapped(estimates, &Estimate::error);
  return curve;
}

std::vector<double> exact_quantiles(std::vector<double> values, const std::vector<double>& p) {
  std::vector<double> result;
  auto first = values.begin();
  for (const double share : p) {
    const auto rank = static_cast<std::size_t>(share * static_cast<double>(values.size()));
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::min(rank, values.size() - 1));
    if (at >= first) std::nth_element(first, at, values.end());
    result.push_back(*at);
    first = at;
  }
  return result;
}

Histogram histogram(const std::vector<double>& x, double factor) {
  Histogram result{{-1, 0.05, 140}, {}};
  const Bins& bins = result.bins;
  std::vector<std::size_t> in(bins.count, 0);
  const double scale = factor / bins.width, shift = bins.low / bins.width, end = static_cast<double>(bins.count);
  for (const double value : x) {
    const double at = value * scale - shift;
    if (at >= 0 && at < end) ++in[static_cast<std::size_t>(at)];
  }
  for (const std::size_t n : in)
    result.density.push_back(static_cast<double>(n) / (static_cast<double>(x.size()) * bins.width));
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
