#include "grains/fields/steady_state.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/problems.hpp"

namespace arenite::fields {
namespace {

constexpr std::size_t batch = 5;         // samples averaged before the search for the end of the transient
constexpr std::size_t least_blocks = 6;  // an error from fewer is known to a third at best

/// Sums of samples, counted from their mean to keep digits.
struct Sums {
  double origin = 0;
  std::vector<double> before{0.0};  // sum over the samples before each, and over all

  explicit Sums(std::span<const double> samples) {
    for (const double v : samples) origin += v / static_cast<double>(samples.size());
    for (const double v : samples) before.push_back(before.back() + (v - origin));
  }
  std::size_t size() const { return before.size() - 1; }

  /// Means of blocks of equal length; samples that fill none are left out at the start, nearest to the transient.
  std::vector<double> block_means(std::size_t length) const {
    std::vector<double> means;
    for (std::size_t k = size() % length; k < size(); k += length)
      means.push_back(origin + (before[k + length] - before[k]) / static_cast<double>(length));
    return means;
  }

  /// Root mean square of the sums of so many neighbours about their mean, of windows that overlap; that mean follows
  /// them, which the last factor makes good.
  double scatter_of_sums(std::size_t length) const {
    double squares = 0;
    for (std::size_t k = length; k < before.size(); ++k)
      squares += (before[k] - before[k - length]) * (before[k] - before[k - length]);
    const double share = static_cast<double>(length) / static_cast<double>(size());
    return std::sqrt(squares / static_cast<double>(before.size() - length) / (1 - share));
  }
};

/// Where the transient ends, in batches: the least of (sum of squares about the mean of what remains) over the square
/// of its number. Sums from the end, each mean and sum of squares from those of one batch less (B. P. Welford,
/// Technometrics 4, 419, 1962).
std::size_t transient(const std::vector<double>& batches, std::size_t limit) {
  double mean = 0, squares = 0, n = 0, least = HUGE_VAL;
  std::size_t best = 0;
  for (std::size_t k = batches.size(); k-- > 0;) {
    const double step = batches[k] - mean;
    mean += step / ++n;
    squares += step * (batches[k] - mean);
    if (k <= limit && squares / (n * n) <= least) {  // of equal ones the earliest, found last
      least = squares / (n * n);
      best = k;
    }
  }
  return best;
}

/// Variance of the mean by blocks over that of as many independent samples; 1 where nothing varies.
double variance_ratio(const Sums& sums, std::size_t length, double plain_error) {
  if (!(plain_error > 0)) return 1;
  const double ratio = statistics::mean_of(sums.block_means(length)).error / plain_error;
  return ratio * ratio;
}

}  // namespace

SteadyState block_average(std::span<const double> samples) {
  const std::size_t n = samples.size();
  SteadyState state;
  state.count = n;
  const statistics::Measured plain = statistics::mean_of({samples.begin(), samples.end()});
  state.mean = {plain.value, statistics::unknown, 0};
  state.deviation = plain.error * std::sqrt(static_cast<double>(n));
  state.samples_per_independent = statistics::unknown;
  if (n < least_blocks) return state;
  const Sums sums(samples);
  for (std::size_t length = 1; n / (2 * length) >= least_blocks; ++length) {
    const double g = variance_ratio(sums, length, plain.error), b = static_cast<double>(length);
    const double left = std::max(g, 1 / g);
    const bool passes = b * b * b > 2 * static_cast<double>(n) * left * left || !(plain.error > 0);
    const bool longest = n / (2 * length + 2) < least_blocks;
    if (!passes && !(longest && g < 1)) continue;
    state.block = 2 * length;
    state.samples_per_independent = variance_ratio(sums, state.block, plain.error);
    const statistics::Measured blocked = statistics::mean_of(sums.block_means(state.block));
    state.mean.error = blocked.error;
    state.mean.freedom = blocked.freedom;
    break;
  }
  return state;
}

double error_of_departures(std::span<const double> samples) {
  const std::size_t n = samples.size();
  if (n < 48) return statistics::unknown;
  const Sums sums(samples);
  const double few = sums.scatter_of_sums(n / 16), many = sums.scatter_of_sums(n / 6);
  if (!(few > 0)) return 0;
  const double times = static_cast<double>(n / 6) / static_cast<double>(n / 16);
  const double power = std::clamp(std::log(many / few) / std::log(times), 0.0, 0.5);
  const double whole = static_cast<double>(n) / static_cast<double>(n / 16);
  return few * std::pow(whole, power) / static_cast<double>(n);
}

std::vector<double> about_ratio_of_means(std::span<const double> a, std::span<const double> b, std::size_t first) {
  const auto mean = [&](std::span<const double> v) {
    return std::accumulate(v.begin() + static_cast<std::ptrdiff_t>(first), v.end(), 0.0) /
           static_cast<double>(v.size() - first);
  };
  const double below = mean(b), ratio = mean(a) / below, sign = ratio < 0 ? -1 : 1;
  std::vector<double> about;
  for (std::size_t k = first; k < a.size(); ++k) about.push_back(sign * (ratio + (a[k] - ratio * b[k]) / below));
  return about;
}

statistics::Measured mean_of_blocks(std::span<const double> samples, std::size_t blocks) {
  const std::size_t length = samples.size() / blocks;
  std::vector<double> means;
  for (std::size_t b = 1; b <= blocks && length > 0; ++b) {
    const auto block = samples.last(b * length).first(length);
    means.push_back(std::accumulate(block.begin(), block.end(), 0.0) / static_cast<double>(length));
  }
  return statistics::mean_of(means);
}

std::span<const double> later_half(std::span<const double> samples) { return samples.subspan(samples.size() / 2); }

statistics::Measured late_mean(std::span<const double> samples) {
  constexpr std::size_t blocks = 10;
  return mean_of_blocks(later_half(samples), blocks);
}

SteadyState find_steady_state(std::span<const double> samples) {
  if (const auto bad = std::find_if(samples.begin(), samples.end(), [](double v) { return !std::isfinite(v); });
      bad != samples.end())
    throw refusal("sample {} of the time series is {}; give finite numbers", bad - samples.begin(), *bad);
  const std::size_t batches = samples.size() / batch, limit = batches / 2;
  // Batches fill the series from its end; what is left over at the start goes with the transient.
  const std::size_t cut = batches > 0 ? transient(Sums(samples).block_means(batch), limit) : 0;
  const std::size_t twice = std::min(2 * cut, limit), first = twice > 0 ? samples.size() % batch + twice * batch : 0;
  SteadyState state = block_average(samples.subspan(first));
  state.first = first;
  state.settled = cut < limit;
  state.reached = state.settled && std::isfinite(state.mean.error);
  return state;
}

}  // namespace arenite::fields
