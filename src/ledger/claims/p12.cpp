#include <fmt/format.h>

#include "ledger/claims/claims.hpp"
#include "ledger/claims/paper_checks.hpp"
#include "ledger/claims/paper_choices.hpp"
#include "ledger/claims/paper_loads.hpp"

namespace arenite::ledger {
namespace {

/// The mean at the greatest gamma less the greatest of the others.
Value lead_of_last(const Series& points) {
  Value lead;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Value here = difference({points.back().mean, points.back().error}, {points[k].mean, points[k].error});
    if (!(lead.value <= here.value)) lead = here;
  }
  return lead;
}

Value growth_of_q(const Samples& samples, double theta) { return slope(against_gamma(stress_means(samples, "large", "q_gaussian.q"), theta)); }

Value lead_of_kurtosis(const Samples& samples, double theta) { return lead_of_last(against_gamma(stress_means(samples, "large", "excess_kurtosis"), theta)); }

std::string growth_text(double theta) { return fmt::format("slope of q against gamma, theta {:g}", theta); }
std::string lead_text(double theta) { return fmt::format("excess kurtosis at the greatest gamma less the greatest other, theta {:g}", theta); }

Verdict sharpened_p12(const Samples& samples) {
  Verdict v;
  for (const double theta : thetas(stress_means(samples, "large", "q_gaussian.q"))) {
    v.checks.push_back(positive(growth_text(theta), "> 0", growth_of_q(samples, theta)));
    v.checks.push_back(positive(lead_text(theta), "> 0", lead_of_kurtosis(samples, theta)));
  }
  return v;
}

}  // namespace

/// Shape of the pdf in large grains of full samples.
Judgement judge_p12(const Results& results) {
  const Samples samples = paper_samples(results);
  Judgement j;
  for (const double theta : thetas(stress_means(samples, "large", "q_gaussian.q"))) {
    j.stated.checks.push_back(above(growth_text(theta), "> 0", growth_of_q(samples, theta), 0));
    j.stated.checks.push_back(above(lead_text(theta), "> 0", lead_of_kurtosis(samples, theta), 0));
  }
  j.sharpened = sharpened_p12(samples);
  add_shear(j, results, sharpened_p12);
  for (const double theta : {1.4, 6.0}) {
    add_choices(j, results, growth_text(theta), [=](const Samples& s) { return growth_of_q(s, theta); }, wanted_positive());
    add_choices(j, results, lead_text(theta), [=](const Samples& s) { return lead_of_kurtosis(s, theta); }, wanted_positive());
  }
  return j;
}

}  // namespace arenite::ledger
