#include "statistics/tail_fit.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/cut_laws.hpp"
#include "statistics/even_density.hpp"
#include "statistics/jackknife.hpp"
#include "statistics/line.hpp"

namespace arenite::statistics {
namespace {

/// What likelihoods of a tail need of its values: number, sum of x - low, sum of (x - 1)^2.
struct TailSums {
  double n = 0, excess = 0, squares = 0;

  TailSums without(const TailSums& b) const { return {n - b.n, excess - b.excess, squares - b.squares}; }
};

std::vector<TailSums> sums_by_block(const BlockedSample& sample, TailRange range) {
  std::vector<TailSums> sums(static_cast<std::size_t>(sample.blocks));
  for (std::size_t i = 0; i < sample.x.size(); ++i) {
    const double x = sample.x[i];
    if (x < range.low || x >= range.high) continue;
    TailSums& s = sums[sample.block[i]];
    s.n += 1;
    s.excess += x - range.low;
    s.squares += (x - 1) * (x - 1);
  }
  return sums;
}

Line line_through(const Bins& bins, const Counts& counts, TailRange range) {
  std::vector<double> x, y;
  const std::vector<double> f = density(bins, counts);
  for (std::size_t k = 0; k < bins.count; ++k)
    if (bins.centre(k) > range.low && bins.centre(k) < range.high && f[k] > 0) {
      x.push_back(bins.centre(k));
      y.push_back(std::log(f[k]));
    }
  return fit_line(x, y);
}

/// Lead of the exponential over the Gaussian about 1, and how sure it is by its parts from each block.
void compare(const std::vector<TailSums>& sums, TailSums all, TailRange range, double slope, TailFit& fit) {
  const double a = range.low - 1, b = range.high - 1, theta = cut_gaussian_rate(all.squares / all.n, a, b);
  const double exponential = log_integral_exponential(slope, b - a), gaussian = log_integral_gaussian(theta, a, b);
  double lead = 0, squares = 0;
  for (const TailSums& s : sums) {
    const double part = s.n * (gaussian - exponential) - slope * s.excess + theta * s.squares;
    lead += part;
    squares += part * part;
  }
  const double blocks = static_cast<double>(sums.size());
  fit.likelihood_ratio = lead;
  const double variance = blocks > 1 ? (squares - lead * lead / blocks) * blocks / (blocks - 1) : 0;
  if (variance > 0) fit.p_value = 0.5 * std::erfc(lead / std::sqrt(2 * variance));
}

}  // namespace

TailRange tail_range(const Bins& bins, const Counts& counts) {
  if (bins.count == 0) return {};
  const std::vector<double> f = smoothed(density(bins, counts));
  const double peak = std::max(0.0, *std::max_element(f.begin(), f.end()));
  std::size_t low = bins.count;
  while (low > 0 && f[low - 1] < 0.1 * peak) --low;
  std::size_t high = low;
  while (high < bins.count && f[high] >= 0.001 * peak) ++high;
  return {bins.edge(low), bins.edge(high)};
}

TailFit fit_tail(const BlockedSample& sample, const BlockCounts& counts, const std::vector<double>& replicate_mean) {
  TailFit fit;
  const TailRange range = tail_range(counts.bins, counts.all);
  if (!(range.high > range.low)) return fit;
  const std::vector<TailSums> sums = sums_by_block(sample, range);
  TailSums all;
  for (const TailSums& s : sums) all = {all.n + s.n, all.excess + s.excess, all.squares + s.squares};
  fit.low = range.low;
  fit.high = range.high;
  fit.count = static_cast<std::size_t>(all.n);
  const Line line = line_through(counts.bins, counts.all, range);
  if (fit.count < 30 || !std::isfinite(line.slope)) return fit;
  const double length = range.high - range.low, slope = cut_exponential_rate(all.excess / all.n, length);
  std::vector<std::vector<double>> replicates;
  for (std::size_t b = 0; b < sums.size(); ++b) {
    const TailSums rest = all.without(sums[b]);
    if (rest.n < 2) continue;
    replicates.push_back({replicate_mean[b] * cut_exponential_rate(rest.excess / rest.n, length),
                          -replicate_mean[b] * line_through(counts.bins, counts.without(b), range).slope});
  }
  const auto estimates = with_errors({slope, -line.slope}, replicates);
  fit.slope = estimates[0];
  fit.line_slope = estimates[1];
  fit.line_r2 = line.r2;
  compare(sums, all, range, slope, fit);
  return fit;
}

}  // namespace arenite::statistics
