#include "statistics/tails.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/root.hpp"
#include "statistics/correlation.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::statistics {

namespace {

/// Lead in likelihood of the exponential of rate beta over the half-Gaussian of the same excesses y > 0.
double lead_over_half_gaussian(const std::vector<double>& y, double beta) {
  double variance = 0, sum = 0;
  const double n = static_cast<double>(y.size());
  for (const double v : y) variance += v * v / n;
  for (const double v : y)
    sum += (std::log(beta) - beta * v) - (0.5 * std::log(2 / (std::numbers::pi * variance)) - v * v / (2 * variance));
  return sum;
}

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
  fit.likelihood_ratio.value = lead;
  if (blocks > 1)
    fit.likelihood_ratio.error = std::sqrt(std::max(0.0, (squares - lead * lead / blocks) * blocks / (blocks - 1)));
  fit.p_value = chance_of_lead(fit.likelihood_ratio);
}

}  // namespace

bool FallBeyondMean::is_known() const { return std::isfinite(level) && std::isfinite(rate); }
double FallBeyondMean::at(double x) const { return level * std::exp(rate * (1 - x)); }
double FallBeyondMean::where(double value) const { return 1 + std::log(level / value) / rate; }

bool WeakPowerLaw::is_known() const { return std::isfinite(k) && std::isfinite(alpha); }
double WeakPowerLaw::at(double x) const { return k * std::pow(x, -alpha); }

bool CutExponential::is_known() const { return std::isfinite(rate) && std::isfinite(low) && std::isfinite(high); }
double CutExponential::at(double x) const {
  const double at_0 = share * rate / (std::exp(-rate * low) - std::exp(-rate * high));
  return at_0 * std::exp(-rate * x);
}

TailFit exponential_tail(const std::vector<double>& sorted) {
  TailFit tail;
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
  const double beta = static_cast<double>(tail.count) / sum;
  tail.slope.value = beta;
  const Line line = fit_line(excess, logarithm);
  tail.line_slope.value = -line.slope;
  tail.line_r2 = line.r2;
  tail.likelihood_ratio.value = lead_over_half_gaussian(excess, beta);
  return tail;
}

double weak_exponent(const std::vector<double>& sorted) {
  const auto first = std::ranges::lower_bound(sorted, least_weak), end = std::ranges::lower_bound(sorted, 1.0);
  const double count = static_cast<double>(end - first);
  if (count < 2) return unknown;
  // y = -ln x has the density exp(-(1 - alpha) y) between 0 and -ln(least_weak).
  double sum = 0;
  for (auto it = first; it != end; ++it) sum -= std::log(*it);
  return 1 - cut_exponential_rate(sum / count, -std::log(least_weak));
}

double share_beyond(const std::vector<double>& values, double threshold) {
  const double limit = threshold + 1e-12 * std::abs(threshold);
  return static_cast<double>(std::ranges::count_if(values, [&](double v) { return v > limit; })) /
         static_cast<double>(values.size());
}

double chance_of_lead(const Estimate& lead) {
  return lead.error > 0 ? 0.5 * std::erfc(lead.value / lead.error / std::numbers::sqrt2) : unknown;
}

double cut_exponential_rate(double mean, double length) {
  // The mean over the length falls from 1 to 0 as a = s length rises.
  const auto relative_mean = [](double a) { return std::abs(a) < 1e-4 ? 0.5 - a / 12 : 1 / a - 1 / std::expm1(a); };
  const auto excess = [&](double a) { return relative_mean(a) - mean / length; };
  double low = -1, high = 1;
  while (excess(low) < 0 && low > -1e9) low *= 2;
  while (excess(high) > 0 && high < 1e9) high *= 2;
  return bracketed_root<double>(excess, low, excess(low), high, excess(high)) / length;
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
  const auto cost = [&](double theta) { return theta * mean_square + log_integral_gaussian(theta, a, b); };
  return minimum_between(cost, 0, a > 0 ? 500 / (a * a) : 100 / mean_square);
}

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

Numbers numbers(const TailFit& fit) {
  Numbers j = Numbers::tree();
  put(j, "slope", fit.slope, "", "s by maximum likelihood of the exponential truncated at both ends");
  put(j, "line_slope", fit.line_slope, "", "s from a straight line through ln pdf in the bins", Trait::detail);
  put(j, "line_r2", fit.line_r2, "", "Fraction of the variance of ln pdf explained by the line", Trait::detail);
  put(j, "low", fit.low, "", "x from which the pdf stays below 0.1 of its peak");
  put(j, "high", fit.high, "", "x where the pdf first falls below 0.001 of its peak");
  put(j, "count", fit.count, "", "Values between low and high");
  put(j, "log_likelihood_ratio", fit.likelihood_ratio, "",
      "ln L(exponential) - ln L(Gaussian about the mean), both truncated at both ends", Trait::detail);
  put(j, "p_value", fit.p_value, "",
      "Probability that the exponential fits better by chance, from the scatter between blocks, one-sided",
      Trait::detail);
  return j;
}

}  // namespace arenite::statistics
