#include "ledger/claims/paper_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace arenite::ledger {
namespace {

template <class Of>
std::vector<double> different(const PairMeans& means, Of of) {
  std::vector<double> values;
  for (const PairMean& m : means) values.push_back(of(m));
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::string name_of(const PairMean& m) { return fmt::format("gamma {:g}, theta {:g}", m.gamma, m.theta); }

bool less(const PairMean& a, const PairMean& b) { return a.value.value < b.value.value; }

}  // namespace

std::string stress_of(const std::string& set, const std::string& statistic) { return "stress.sigma_yy.sets." + set + "." + statistic; }

double gamma_of(const Run& run) { return run.key("bidisperse.size_ratio"); }

double theta_of(const Run& run) { return run.key("bidisperse.volume_ratio"); }

double cement_of(const Run& run) { return run.text("cement.kind") == "full" ? full : run.key("cement.width"); }

PairMeans pair_means(const Results& results, const Number& number, double width) {
  std::map<std::pair<double, double>, std::vector<double>> samples;
  for (const Run& run : results.runs("paper"))
    if (cement_of(run) == width)
      if (const double value = number.of(run); std::isfinite(value)) samples[{gamma_of(run), theta_of(run)}].push_back(value);
  PairMeans means;
  for (const auto& [pair, values] : samples) means.push_back({pair.first, pair.second, width, statistics::mean_of(values)});
  return means;
}

PairMeans only(const PairMeans& means, const std::function<bool(const PairMean&)>& wanted) {
  PairMeans result;
  std::copy_if(means.begin(), means.end(), std::back_inserter(result), wanted);
  return result;
}

PairMeans difference(const PairMeans& a, const PairMeans& b) {
  PairMeans result;
  for (const PairMean& m : a)
    if (const Value other = of_pair(b, m.gamma, m.theta); std::isfinite(other.value))
      result.push_back({m.gamma, m.theta, m.width, difference(m.value, other)});
  return result;
}

Series against_gamma(const PairMeans& means, double theta) {
  Series points;
  for (const PairMean& m : means)
    if (m.theta == theta) points.push_back({m.gamma, m.value.value, m.value.error, 1});
  return points;
}

std::vector<double> thetas(const PairMeans& means) {
  return different(means, [](const PairMean& m) { return m.theta; });
}

std::vector<double> gammas(const PairMeans& means) {
  return different(means, [](const PairMean& m) { return m.gamma; });
}

Value of_pair(const PairMeans& means, double gamma, double theta) {
  for (const PairMean& m : means)
    if (m.gamma == gamma && m.theta == theta) return m.value;
  return {};
}

Value overall(const PairMeans& means) {
  if (means.empty()) return {};
  const double n = static_cast<double>(means.size());
  double sum = 0, squares = 0;
  for (const PairMean& m : means) {
    sum += m.value.value;
    squares += m.value.error * m.value.error;
  }
  return {sum / n, std::sqrt(squares) / n};
}

void add_range(Verdict& verdict, const std::string& what, const std::string& source, const PairMeans& means, double low, double high) {
  const auto [least, greatest] = std::minmax_element(means.begin(), means.end(), less);
  const bool any = !means.empty();
  verdict.checks.push_back(between("least " + what + (any ? " (" + name_of(*least) + ")" : ""), source, any ? least->value : Value(), low, high));
  verdict.checks.push_back(between("greatest " + what + (any ? " (" + name_of(*greatest) + ")" : ""), source, any ? greatest->value : Value(), low, high));
}

Check in_all_pairs(const std::string& what, const std::string& source, const PairMeans& differences, int direction) {
  const Value mean = overall(differences);
  const PairMean* against = nullptr;
  std::size_t sure = 0;
  for (const PairMean& m : differences) {
    const double along = direction * m.value.value, limit = beyond * m.value.error;
    sure += along > limit;
    if (along < -limit && (!against || along < direction * against->value.value)) against = &m;
  }
  const std::string counted = fmt::format("{}, mean of {} pairs, {} of them beyond 2 s.e.", what, differences.size(), sure);
  Check check = direction > 0 ? positive(counted, source, mean) : negative(counted, source, mean);
  check.tolerance += ", no pair against it by 2 s.e.";
  if (against) {
    check.holds = Holds::no;
    check.what += fmt::format("; against it {}: {}", name_of(*against), text_of(against->value));
  }
  return check;
}

void add_rises(Verdict& verdict, const std::string& what, const std::string& source, const PairMeans& means, int direction) {
  for (const double theta : thetas(means)) {
    const std::string name = fmt::format("{}, change from the least to the greatest gamma, theta {:g}", what, theta);
    const Value change = rise(against_gamma(means, theta));
    verdict.checks.push_back(direction > 0 ? positive(name, source, change) : negative(name, source, change));
  }
  if (means.empty()) verdict.checks.push_back(positive(what + " against gamma", source, {}));
}

}  // namespace arenite::ledger
