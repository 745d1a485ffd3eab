#include "statistics/clusters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/mapped.hpp"

namespace arenite::statistics {
namespace {

/// Sums over sorted values, counted from their middle to keep digits.
struct Sums {
  std::vector<double> first{0.0}, second{0.0};
  explicit Sums(const std::vector<double>& sorted, double origin) {
    for (const double v : sorted) {
      first.push_back(first.back() + (v - origin));
      second.push_back(second.back() + (v - origin) * (v - origin));
    }
  }
  /// Sum of squares about the mean of values a .. b-1.
  double scatter(std::size_t a, std::size_t b) const {
    const double n = static_cast<double>(b - a), sum = first[b] - first[a];
    return std::max(0.0, second[b] - second[a] - sum * sum / n);
  }
};

/// Ends of the best k classes for every k up to `most`; ends[k - 1] has k entries.
std::vector<std::vector<std::size_t>> partings(const Sums& sums, std::size_t n, std::size_t most) {
  std::vector<std::vector<double>> cost(most + 1, std::vector<double>(n + 1, std::numeric_limits<double>::infinity()));
  std::vector<std::vector<std::size_t>> cut(most + 1, std::vector<std::size_t>(n + 1, 0));
  cost[0][0] = 0;
  for (std::size_t k = 1; k <= most; ++k)
    for (std::size_t b = k; b <= n; ++b)
      for (std::size_t a = k - 1; a < b; ++a)
        if (const double c = cost[k - 1][a] + sums.scatter(a, b); c < cost[k][b]) {
          cost[k][b] = c;
          cut[k][b] = a;
        }
  std::vector<std::vector<std::size_t>> ends;
  for (std::size_t k = 1; k <= most; ++k) {
    std::vector<std::size_t> of_k(k);
    for (std::size_t i = k, b = n; i > 0; --i) {
      of_k[i - 1] = b;
      b = cut[i][b];
    }
    ends.push_back(std::move(of_k));
  }
  return ends;
}

Clusters classes_of(const std::vector<double>& sorted, const std::vector<std::size_t>& ends, const Sums& sums,
                    double floor) {
  Clusters result;
  std::size_t a = 0;
  for (const std::size_t b : ends) {
    const double n = static_cast<double>(b - a);
    result.mean.push_back(std::accumulate(sorted.begin() + static_cast<std::ptrdiff_t>(a),
                                          sorted.begin() + static_cast<std::ptrdiff_t>(b), 0.0) /
                          n);
    result.spread.push_back(std::max(floor, b - a > 1 ? std::sqrt(sums.scatter(a, b) / (n - 1)) : 0.0));
    result.members.push_back(b - a);
    a = b;
  }
  return result;
}

bool stand_apart(const Clusters& c, const ClusterOptions& options) {
  for (std::size_t k = 0; k < c.size(); ++k) {
    if (c.members[k] < options.least_members) return false;
    if (k == 0) continue;
    const double spread = std::sqrt(0.5 * (c.spread[k] * c.spread[k] + c.spread[k - 1] * c.spread[k - 1]));
    if (!(c.mean[k] - c.mean[k - 1] > options.separation * spread)) return false;
  }
  return true;
}

}  // namespace

Clusters cluster(const std::vector<double>& values, const ClusterOptions& options) {
  if (values.empty()) return {};
  const auto order = ordered_by(values.size(), [&](std::size_t i) { return values[i]; });
  const auto sorted = mapped(order, [&](std::size_t i) { return values[i]; });
  const Sums sums(sorted, sorted[sorted.size() / 2]);
  const auto ends = partings(sums, sorted.size(), std::max<std::size_t>(1, std::min(options.most, sorted.size())));
  std::size_t k = ends.size();
  Clusters best = classes_of(sorted, ends[k - 1], sums, options.floor);
  while (k > 1 && !stand_apart(best, options)) best = classes_of(sorted, ends[--k - 1], sums, options.floor);
  best.of.resize(values.size());
  for (std::size_t i = 0, c = 0; i < order.size(); ++i) {
    while (i >= ends[k - 1][c]) ++c;
    best.of[order[i]] = static_cast<std::int32_t>(c);
  }
  return best;
}

}  // namespace arenite::statistics
