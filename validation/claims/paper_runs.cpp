#include "validation/claims/paper_runs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "validation/claims/paper_errors.hpp"

namespace arenite::validation {
namespace {

template <class Of> std::vector<double> different(const PairMeans& means, Of of) {
  std::vector<double> values;
  for (const PairMean& m : means) values.push_back(of(m));
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

Value mean_over(const std::vector<Sample>& samples) {
  std::vector<double> numbers;
  for (const Sample& s : samples) numbers.push_back(s.number);
  return numbers.empty() ? Value() : statistics::mean_of(numbers);
}

std::vector<Sample> change_by_seed(const std::vector<Sample>& a, const std::vector<Sample>& b) {
  std::vector<Sample> result;
  for (const Sample& one : a)
    for (const Sample& other : b)
      if (one.name == other.name) result.push_back({one.name, one.number - other.number});
  return result;
}

}  // namespace

PairMeans without(PairMeans means, std::size_t k) {
  for (PairMean& m : means) {
    m.samples.erase(m.samples.begin() + static_cast<std::ptrdiff_t>(k));
    m.value = mean_over(m.samples);
  }
  return means;
}

PairMeans without(PairMeans means, double gamma, double theta, const std::string& sample) {
  for (PairMean& m : means) {
    if (m.gamma != gamma || m.theta != theta) continue;
    std::erase_if(m.samples, [&](const Sample& s) { return s.name == sample; });
    m.value = mean_over(m.samples);
  }
  return means;
}

std::size_t fewest_samples(const std::vector<PairMeans>& means) {
  std::size_t fewest = 0;
  for (const PairMeans& some : means)
    for (const PairMean& m : some) fewest = fewest == 0 ? m.samples.size() : std::min(fewest, m.samples.size());
  return fewest;
}

Samples paper_samples(const Results& results) { return {results.runs("paper"), {0.2, 0.4, 0.6, 0.8, 1}}; }

double gamma_of(const Run& run) { return run.key("bidisperse.size_ratio"); }

double theta_of(const Run& run) { return run.key("bidisperse.volume_ratio"); }

double cement_of(const Run& run) { return run.text("cement.kind") == "full" ? full : run.key("cement.width"); }

PairMeans pair_means(const Samples& samples, const Number& number, double width) {
  std::map<std::pair<double, double>, std::vector<Sample>> pairs;
  for (const Run& run : samples.runs)
    if (cement_of(run) == width)
      if (const double value = number.of(run); std::isfinite(value))
        pairs[{gamma_of(run), theta_of(run)}].push_back({run.text("seed"), value});
  PairMeans means;
  for (auto& [pair, all] : pairs) means.push_back(pair_of_samples(pair.first, pair.second, width, std::move(all)));
  return with_pooled_variance(std::move(means));
}

PairMeans stress_means(const Samples& samples, const std::string& set, const std::string& statistic, double width) {
  return pair_means(samples, "stress." + samples.component + ".sets." + set + "." + statistic, width);
}

PairMean pair_of_samples(double gamma, double theta, double width, std::vector<Sample> samples) {
  return {gamma, theta, width, mean_over(samples), std::move(samples)};
}

PairMeans only(const PairMeans& means, const std::function<bool(const PairMean&)>& wanted) {
  PairMeans result;
  std::copy_if(means.begin(), means.end(), std::back_inserter(result), wanted);
  return result;
}

PairMeans classed(const PairMeans& means) {
  return only(means, [](const PairMean& m) { return m.gamma >= 1.43; });
}

PairMeans of_theta(const PairMeans& means, double theta) {
  return only(means, [=](const PairMean& m) { return m.theta == theta; });
}

PairMeans difference(const PairMeans& a, const PairMeans& b) {
  PairMeans result;
  for (const PairMean& m : a)
    for (const PairMean& other : b) {
      if (m.gamma != other.gamma || m.theta != other.theta) continue;
      auto samples = change_by_seed(m.samples, other.samples);
      if (!samples.empty()) result.push_back(pair_of_samples(m.gamma, m.theta, m.width, std::move(samples)));
    }
  return with_pooled_variance(std::move(result));
}

PairMeans mean_of(const std::vector<PairMeans>& all) {
  std::map<std::pair<double, double>, std::map<std::string, std::pair<double, double>>>
      pairs;  // sum and count of each sample
  for (const PairMeans& means : all)
    for (const PairMean& m : means)
      for (const Sample& sample : m.samples) {
        auto& [sum, count] = pairs[{m.gamma, m.theta}][sample.name];
        sum += sample.number;
        count += 1;
      }
  PairMeans result;
  for (const auto& [pair, sums] : pairs) {
    std::vector<Sample> samples;
    for (const auto& [name, sum] : sums) samples.push_back({name, sum.first / sum.second});
    result.push_back(pair_of_samples(pair.first, pair.second, full, std::move(samples)));
  }
  return with_pooled_variance(std::move(result));
}

Series against_gamma(const PairMeans& means, double theta) {
  Series points;
  for (const PairMean& m : means)
    if (m.theta == theta)
      points.push_back({m.gamma, m.value.value, m.value.error, m.samples.size(),
                        is_pooled(m) ? m.value.freedom : statistics::unknown});
  return points;
}

Series against(const PairMeans& x, const PairMeans& y) {
  Series points;
  for (const PairMean& m : x)
    if (const Value v = of_pair(y, m.gamma, m.theta); std::isfinite(v.value))
      points.push_back({m.value.value, v.value, v.error, 1});
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
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

Family members(const PairMeans& means) {
  Family family;
  for (const PairMean& m : means)
    family.push_back({name_of(m),
                      m.value,
                      {{"paper",
                        {{"bidisperse.size_ratio", fmt::format("{:g}", m.gamma)},
                         {"bidisperse.volume_ratio", fmt::format("{:g}", m.theta)}}}}});
  return family;
}

Value overall(const PairMeans& means) {
  if (means.empty()) return {};
  std::vector<std::pair<double, Value>> terms;
  double pooled = 0;
  for (const PairMean& m : means) {
    terms.emplace_back(1 / static_cast<double>(means.size()), m.value);
    if (is_pooled(m)) pooled = std::max(pooled, m.value.freedom);
  }
  Value sum = weighted_sum(terms);
  if (pooled > 0) sum.freedom = std::min(sum.freedom, pooled);  // one variance, counted once
  return sum;
}

std::string name_of(const PairMean& m) { return fmt::format("gamma {:g}, theta {:g}", m.gamma, m.theta); }

}  // namespace arenite::validation
