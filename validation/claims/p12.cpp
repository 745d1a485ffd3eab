#include <fmt/core.h>

#include "validation/claims/claims.hpp"
#include "validation/claims/paper_checks.hpp"
#include "validation/claims/paper_choices.hpp"
#include "validation/claims/paper_elements.hpp"
#include "validation/claims/paper_loads.hpp"

namespace arenite::validation {
namespace {

PairMeans q_of(const Samples& samples) { return stress_means(samples, "large", "q_gaussian.q"); }
PairMeans kurtosis_of(const Samples& samples) { return stress_means(samples, "large", "excess_kurtosis"); }

/// Where the kurtosis at the greatest gamma is less than at another, all pairs together.
Family leads_of_greatest(const PairMeans& kurtosis) {
  Family family;
  for (const double theta : thetas(kurtosis))
    for (const Member& m : leads_of_last(against_gamma(kurtosis, theta)))
      family.push_back({fmt::format("gamma {} at theta {:g}", m.name, theta), m.value});
  return family;
}

/// The same of the mean of all others, over all theta; the members above share their last.
Value lead_of_greatest(const PairMeans& kurtosis) {
  const auto all = thetas(kurtosis);
  std::vector<std::pair<double, Value>> terms;
  for (const double theta : all) {
    const Series points = against_gamma(kurtosis, theta);
    const double share = 1 / static_cast<double>(all.size()), others = static_cast<double>(points.size()) - 1;
    for (const Point& p : points) terms.emplace_back(p.x == points.back().x ? share : -share / others, value_of(p));
  }
  return terms.size() < 2 ? Value() : weighted_sum(terms);
}

std::vector<Check> asked_p12(const Samples& samples) {
  const PairMeans kurtosis = kurtosis_of(samples);
  return {with_gamma("q", "grows", q_of(samples), +1),
          with_gamma("the excess kurtosis in large grains", "highest at the largest gamma", kurtosis, +1),
          on_the_whole("excess kurtosis at the largest gamma minus that at another", "highest there",
                       lead_of_greatest(kurtosis), leads_of_greatest(kurtosis), +1)};
}

}  // namespace

/// Shape of the pdf in large grains of full samples.
Judgement judge_p12(const Results& results) {
  const Samples samples = paper_samples(results);
  Judgement j;
  j.checks = asked_p12(samples);
  add_shear(j, results, asked_p12);
  add_elements(j, results, asked_p12);
  for (const double theta : {1.4, 6.0}) {
    add_choices(
        j, results, fmt::format("Slope of q against gamma, theta {:g}", theta),
        [=](const Samples& s) { return slope(against_gamma(q_of(s), theta)); }, wanted_positive());
    add_choices(
        j, results, fmt::format("Slope of the excess kurtosis against gamma, theta {:g}", theta),
        [=](const Samples& s) { return slope(against_gamma(kurtosis_of(s), theta)); }, wanted_positive());
  }
  return j;
}

}  // namespace arenite::validation
