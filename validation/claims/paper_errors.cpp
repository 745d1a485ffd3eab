#include "validation/claims/paper_errors.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace arenite::validation {
namespace {

double square_sum(const PairMean& pair) {
  double sum = 0;
  for (const Sample& s : pair.samples) sum += std::pow(s.number - pair.value.value, 2);
  return sum;
}

/// The 99 % quantile of chi-squared, after Wilson and Hilferty.
double chi_squared_99(double freedom) {
  const double ninth = 2 / (9 * freedom);
  return freedom * std::pow(1 - ninth + 2.326 * std::sqrt(ninth), 3);
}

/// Whether the samples of these pairs can have one variance, by Bartlett's test at 1 %.
bool have_one_variance(const std::vector<const PairMean*>& pairs, double variance, double freedom) {
  double logs = 0, inverse = 0;
  for (const PairMean* pair : pairs) {
    const double own = static_cast<double>(pair->samples.size()) - 1;
    if (own < 1) continue;
    logs += own * std::log(square_sum(*pair) / own);
    inverse += 1 / own;
  }
  const auto groups =
      static_cast<double>(std::ranges::count_if(pairs, [](const PairMean* pair) { return pair->samples.size() > 1; }));
  if (groups < 2) return false;
  const double correction = 1 + (inverse - 1 / freedom) / (3 * (groups - 1));
  return (freedom * std::log(variance) - logs) / correction < chi_squared_99(groups - 1);
}

/// Gives these pairs the errors of one variance, if they can have one.
bool pool(const std::vector<PairMean*>& pairs) {
  double squares = 0, freedom = 0;
  for (const PairMean* pair : pairs) {
    squares += square_sum(*pair);
    freedom += static_cast<double>(pair->samples.size()) - 1;
  }
  if (!(freedom > 0) || !have_one_variance({pairs.begin(), pairs.end()}, squares / freedom, freedom)) return false;
  for (PairMean* pair : pairs) {
    pair->value.error = std::sqrt(squares / freedom / static_cast<double>(pair->samples.size()));
    pair->value.freedom = freedom;
  }
  return true;
}

}  // namespace

bool is_pooled(const PairMean& pair) { return pair.value.freedom > static_cast<double>(pair.samples.size()) - 0.5; }

PairMeans with_pooled_variance(PairMeans means) {
  std::vector<PairMean*> all;
  std::map<double, std::vector<PairMean*>> by_gamma;
  for (PairMean& m : means) {
    all.push_back(&m);
    by_gamma[m.gamma].push_back(&m);
  }
  if (!pool(all))
    for (const auto& [gamma, pairs] : by_gamma) pool(pairs);
  return means;
}

Value jackknifed(const std::vector<PairMeans>& means,
                 const std::function<double(const std::vector<PairMeans>&)>& number) {
  std::map<std::pair<double, double>, std::set<std::string>> packings;
  for (const PairMeans& some : means)
    for (const PairMean& m : some)
      for (const Sample& s : m.samples) packings[{m.gamma, m.theta}].insert(s.name);
  Value result{number(means)};
  double variance = 0, of_freedom = 0;
  for (const auto& [pair, names] : packings) {
    if (names.size() < 2) return result;
    std::vector<double> left;
    for (const std::string& name : names) {
      std::vector<PairMeans> fewer;
      for (const PairMeans& some : means) fewer.push_back(without(some, pair.first, pair.second, name));
      left.push_back(number(fewer));
    }
    // Values with one of n left out scatter n - 1 times less than those of one alone would.
    const double others = static_cast<double>(names.size()) - 1,
                 own = std::pow(others * statistics::mean_of(left).error, 2);
    variance += own;
    of_freedom += own * own / others;
  }
  if (packings.empty()) return result;
  result.error = std::sqrt(variance);
  result.freedom = of_freedom > 0 ? variance * variance / of_freedom : statistics::unknown;
  return result;
}

Value jackknifed(const PairMeans& means, const std::function<double(const PairMeans&)>& number) {
  return jackknifed(std::vector<PairMeans>{means},
                    [&](const std::vector<PairMeans>& all) { return number(all.front()); });
}

}  // namespace arenite::validation
