#include "validation/claims/paper_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "validation/claims/paper_errors.hpp"

namespace arenite::validation {
namespace {

bool less(const PairMean& a, const PairMean& b) { return a.value.value < b.value.value; }

Series line_points(const PairMeans& means, double theta, Against against) {
  Series points = against_gamma(means, theta);
  if (against == Against::gamma) return points;
  for (Point& p : points) p.x = 1 / p.x;
  std::reverse(points.begin(), points.end());
  return points;
}

/// The same pair; without samples if there is none.
PairMean pair_like(const PairMeans& means, const PairMean& like) {
  const auto at = std::find_if(means.begin(), means.end(),
                               [&](const PairMean& m) { return m.gamma == like.gamma && m.theta == like.theta; });
  return at == means.end() ? PairMean{like.gamma, like.theta, like.width, {}, {}} : *at;
}

const Sample* sample_of(const PairMean& pair, const std::string& name) {
  const auto at =
      std::find_if(pair.samples.begin(), pair.samples.end(), [&](const Sample& s) { return s.name == name; });
  return at == pair.samples.end() ? nullptr : &*at;
}

/// Mean without that sample; with it where it is the only one.
double mean_without(const PairMean& pair, const std::string& name) {
  double sum = 0, count = 0;
  for (const Sample& s : pair.samples)
    if (s.name != name || pair.samples.size() == 1) sum += s.number, ++count;
  return sum / count;
}

}  // namespace

void draw_packings_alone(Judgement& judgement) {
  for (Check& check : judgement.checks) {
    if (check.draws.empty()) check.draws.push_back({"paper", {}});
    for (Draw& draw : check.draws) draw.where.emplace_back("cement.kind", "full");
  }
}

Check in_range(const std::string& what, const std::string& source, const PairMeans& means, double low, double high) {
  return every(what, source, members(means), {low, high});
}

Family by_theta(const PairMeans& means, const std::function<Value(double theta)>& number) {
  Family family;
  for (const double theta : thetas(means))
    family.push_back({fmt::format("theta {:g}", theta),
                      number(theta),
                      {{"paper", {{"bidisperse.volume_ratio", fmt::format("{:g}", theta)}}}}});
  return family;
}

Check with_gamma(const std::string& what, const std::string& source, const PairMeans& means, int direction) {
  const Family slopes = by_theta(means, [&](double theta) { return slope(against_gamma(means, theta)); });
  return every("slope of " + what + " against gamma", source, slopes,
               direction > 0 ? Range{.low = 0} : Range{.high = 0});
}

Value straightness(const PairMeans& means, double theta, Against against) {
  if (against_gamma(means, theta).size() < 3) return {};
  return jackknifed(of_theta(means, theta),
                    [&](const PairMeans& some) { return line_r2(line_points(some, theta, against)); });
}

Check straight(const std::string& what, const std::string& source, const PairMeans& means, Against against) {
  const Family r2 = by_theta(means, [&](double theta) { return straightness(means, theta, against); });
  return every(fmt::format("R^2 of {} against {}", what, against == Against::gamma ? "gamma" : "1/gamma"), source, r2,
               {.low = 0.98});
}

Dip dip(const PairMeans& means, double theta) {
  const PairMeans points = of_theta(means, theta);
  if (points.size() < 3) return {};
  const std::size_t samples = fewest_samples({points});
  std::vector<double> falls, rises;
  for (std::size_t k = 0; k < samples; ++k) {
    const PairMeans others = samples > 1 ? without(points, k) : points;
    const auto lowest = static_cast<std::size_t>(std::min_element(others.begin(), others.end(), less) - others.begin());
    const auto own = [&](const PairMean& m) { return m.samples[k].number; };
    falls.push_back(own(points.front()) - own(points[lowest]));
    rises.push_back(own(points.back()) - own(points[lowest]));
  }
  if (falls.empty()) return {};
  const PairMean& lowest = *std::min_element(points.begin(), points.end(), less);
  Dip found{difference(points.front().value, lowest.value), difference(points.back().value, lowest.value)};
  found.fall.value = statistics::mean_of(falls).value;
  found.rise.value = statistics::mean_of(rises).value;
  return found;
}

PairMeans at_greatest(const std::vector<PairMeans>& sizes, const std::vector<PairMeans>& numbers) {
  PairMeans result;
  if (sizes.empty()) return result;
  for (const PairMean& pair : sizes.front()) {
    std::vector<Sample> own;
    for (const Sample& sample : pair.samples) {
      std::size_t best = 0;
      for (std::size_t k = 1; k < sizes.size(); ++k)
        if (mean_without(pair_like(sizes[k], pair), sample.name) >
            mean_without(pair_like(sizes[best], pair), sample.name))
          best = k;
      if (const PairMean there = pair_like(numbers[best], pair); const Sample* number = sample_of(there, sample.name))
        own.push_back(*number);
    }
    if (!own.empty()) result.push_back(pair_of_samples(pair.gamma, pair.theta, pair.width, std::move(own)));
  }
  return with_pooled_variance(std::move(result));
}

}  // namespace arenite::validation
