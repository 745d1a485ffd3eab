#include "statistics/jackknife.hpp"

#include <algorithm>
#include <cmath>

#include "core/mapped.hpp"

namespace arenite::statistics {
namespace {

/// Numbers of the blocks that hold items, in rising order.
std::vector<int> used_blocks(const Items& items, const std::vector<int>& block_of) {
  auto used = mapped(items, [&](std::size_t i) { return block_of[i]; });
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

}  // namespace

double standard_error(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  if (values.size() < 2) return unknown;
  double sum = 0, squares = 0;
  for (const double v : values) sum += v;
  for (const double v : values) squares += (v - sum / n) * (v - sum / n);
  return std::sqrt(squares / (n * (n - 1)));
}

std::vector<Estimate> with_errors(const std::vector<double>& values, const std::vector<std::vector<double>>& replicates,
                                  const std::vector<double>& periods) {
  std::vector<Estimate> result(values.size());
  const double n = static_cast<double>(replicates.size());
  for (std::size_t s = 0; s < values.size(); ++s) {
    result[s].value = values[s];
    if (replicates.size() < 2) continue;
    double sum = 0, squares = 0;
    for (const auto& replicate : replicates) {
      double d = replicate[s] - values[s];
      if (s < periods.size() && periods[s] > 0) d = std::remainder(d, periods[s]);
      sum += d;
      squares += d * d;
    }
    // Of blocks without which a statistic has no value its error is not known.
    const double variance = (n - 1) / n * (squares - sum * sum / n);
    if (std::isfinite(variance)) result[s].error = std::sqrt(std::max(0.0, variance));
  }
  return result;
}

std::vector<Estimate> jackknife(const Items& items, const std::vector<int>& block_of,
                                const std::function<std::vector<double>(const Items&)>& statistics,
                                const std::vector<double>& periods) {
  std::vector<std::vector<double>> replicates;
  Items rest;
  for (const int block : used_blocks(items, block_of)) {
    rest.clear();
    for (const std::size_t i : items)
      if (block_of[i] != block) rest.push_back(i);
    replicates.push_back(statistics(rest));
  }
  return with_errors(statistics(items), replicates, periods);
}

std::vector<Estimate> jackknife_of_sums(
    const Items& items, const std::vector<int>& block_of, std::size_t terms,
    const std::function<void(std::size_t, double*)>& add,
    const std::function<std::vector<double>(const std::vector<double>&)>& statistics,
    const std::vector<double>& periods) {
  const std::vector<int> used = used_blocks(items, block_of);
  std::vector<std::vector<double>> sums(used.size(), std::vector<double>(terms, 0.0));
  for (const std::size_t i : items)
    add(i,
        sums[static_cast<std::size_t>(std::lower_bound(used.begin(), used.end(), block_of[i]) - used.begin())].data());
  std::vector<double> total(terms, 0.0);
  for (const auto& block : sums)
    for (std::size_t t = 0; t < terms; ++t) total[t] += block[t];
  std::vector<std::vector<double>> replicates;
  std::vector<double> rest(terms);
  for (const auto& block : sums) {
    for (std::size_t t = 0; t < terms; ++t) rest[t] = total[t] - block[t];
    replicates.push_back(statistics(rest));
  }
  return with_errors(statistics(total), replicates, periods);
}

Estimate mean(const Items& items, const std::vector<int>& block_of, const std::function<double(std::size_t)>& value) {
  if (items.empty()) return {};
  const auto add = [&](std::size_t i, double* sums) {
    sums[0] += 1;
    sums[1] += value(i);
  };
  const auto ratio = [](const std::vector<double>& sums) { return std::vector<double>{sums[1] / sums[0]}; };
  return jackknife_of_sums(items, block_of, 2, add, ratio)[0];
}

}  // namespace arenite::statistics
