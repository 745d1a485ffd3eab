#include "texture/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arenite::texture {
namespace {

double mean_of(const Items& items, const std::vector<double>& value) {
  double sum = 0;
  for (const std::size_t i : items) sum += value[i];
  return sum / static_cast<double>(items.size());
}

/// Share of items beyond the mean, on the mean's side: for stresses under compression both are negative.
double share_beyond(const Items& items, const std::vector<double>& value, double mean) {
  double above = 0;
  for (const std::size_t i : items) above += value[i] / mean > 1;
  return above / static_cast<double>(items.size());
}

struct Line {
  double slope = unknown, slope_error = unknown, r2 = unknown;
};

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
  return {slope, std::sqrt(residual / (n - 2) / xx), 1 - residual / yy};
}

/// Vuong's comparison of two fits of the excesses y > 0: exponential of rate beta, half-Gaussian of the same data.
void compare_with_half_gaussian(const std::vector<double>& y, double beta, ExponentialTail& tail) {
  double variance = 0;
  const double n = static_cast<double>(y.size());
  for (const double v : y) variance += v * v / n;
  double sum = 0, squares = 0;
  for (const double v : y) {
    const double lead = (std::log(beta) - beta * v) - (0.5 * std::log(2 / (std::numbers::pi * variance)) - v * v / (2 * variance));
    sum += lead;
    squares += lead * lead;
  }
  const double spread = std::sqrt(std::max(0.0, squares - sum * sum / n));
  tail.likelihood_ratio = sum;
  if (spread > 0) tail.p_value = 0.5 * std::erfc(sum / spread / std::numbers::sqrt2);
}

Curve density(const std::vector<double>& sorted) {
  Curve curve;
  const double top = sorted.back(), n = static_cast<double>(sorted.size());
  if (!(top > 0)) return curve;
  const double width = std::max(0.1, top / 100);
  std::vector<double> count(static_cast<std::size_t>(top / width) + 1, 0.0);
  for (const double x : sorted)
    if (x >= 0) count[static_cast<std::size_t>(x / width)] += 1;
  for (std::size_t k = 0; k < count.size(); ++k) {
    curve.x.push_back((static_cast<double>(k) + 0.5) * width);
    curve.y.push_back(count[k] / (n * width));
    curve.error.push_back(std::sqrt(count[k]) / (n * width));
  }
  return curve;
}

/// Share at or above x, at up to about 200 of the values themselves: all ranks of the far tail, then ever fewer.
Curve share_above_curve(const std::vector<double>& sorted) {
  Curve curve;
  const std::size_t n = sorted.size();
  for (std::size_t rank = n; rank >= 1; rank = std::min(rank - 1, static_cast<std::size_t>(static_cast<double>(rank) / 1.035))) {
    const double share = static_cast<double>(rank) / static_cast<double>(n);
    curve.x.push_back(sorted[n - rank]);
    curve.y.push_back(share);
    curve.error.push_back(std::sqrt(share * (1 - share) / static_cast<double>(n)));
  }
  return curve;
}

/// k and beta^2/((1 - alpha)(2 - alpha)), with errors carried over from beta and alpha as independent.
void relate(Distribution& d) {
  const double beta = d.tail.beta.value, a = d.weak.alpha.value, sb = d.tail.beta.error, sa = d.weak.alpha.error;
  const double k = 1 / (1 / (1 - a) + 1 / beta);
  d.k = {k, k * k * std::hypot(sa / ((1 - a) * (1 - a)), sb / (beta * beta))};
  const double product = (1 - a) * (2 - a), ratio = beta * beta / product;
  d.relation = {ratio, ratio * std::hypot(2 * sb / beta, (3 - 2 * a) * sa / product)};
}

}  // namespace

ExponentialTail exponential_tail(const std::vector<double>& sorted) {
  ExponentialTail tail;
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
  const double count = static_cast<double>(tail.count), beta = count / sum;
  tail.beta = {beta, beta / std::sqrt(count)};
  const Line line = fit_line(excess, logarithm);
  tail.line_beta = {-line.slope, line.slope_error};
  tail.line_r2 = line.r2;
  compare_with_half_gaussian(excess, beta, tail);
  return tail;
}

PowerLaw weak_power_law(const std::vector<double>& sorted) {
  PowerLaw law;
  double sum = 0;
  for (const double x : sorted) {
    if (x <= 0) continue;
    if (x >= 1) break;
    sum -= std::log(x);
    ++law.count;
  }
  if (law.count < 2) return law;
  const double n = static_cast<double>(law.count);
  law.alpha = {1 - n / sum, n / sum / std::sqrt(n)};
  return law;
}

Distribution distribution(const Items& items, const std::vector<int>& block_of, const std::vector<double>& value,
                          double mean_of_all, double scale) {
  Distribution d;
  d.count = items.size();
  if (items.empty()) return d;
  const auto statistics = [&](const Items& set) {
    if (set.empty()) return std::vector<double>(3, unknown);
    const double mean = mean_of(set, value);
    return std::vector<double>{mean * scale, share_beyond(set, value, mean), share_beyond(set, value, mean_of_all)};
  };
  const auto estimates = jackknife(items, block_of, statistics);
  d.mean = estimates[0];
  d.share_above = estimates[1];
  d.share_above_all = estimates[2];
  const double own_mean = mean_of(items, value);
  if (own_mean == 0) return d;
  std::vector<double> sorted;
  for (const std::size_t i : items) sorted.push_back(value[i] / own_mean);
  std::sort(sorted.begin(), sorted.end());
  d.maximum = sorted.back();
  d.tail = exponential_tail(sorted);
  d.weak = weak_power_law(sorted);
  relate(d);
  d.pdf = density(sorted);
  d.cumulative = share_above_curve(sorted);
  return d;
}

}  // namespace arenite::texture
