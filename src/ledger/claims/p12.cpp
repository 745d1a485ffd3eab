#include <fmt/format.h>

#include "ledger/claims/claims.hpp"
#include "ledger/claims/paper_runs.hpp"

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

}  // namespace

/// Shape of the pdf in large grains of full samples.
Judgement judge_p12(const Results& results) {
  const PairMeans q = pair_means(results, stress_of("large", "q_gaussian.q"), full);
  const PairMeans kurtosis = pair_means(results, stress_of("large", "excess_kurtosis"), full);
  Judgement j;
  for (const double theta : thetas(q)) {
    const Value growth = slope(against_gamma(q, theta)), lead = lead_of_last(against_gamma(kurtosis, theta));
    j.stated.checks.push_back(above(fmt::format("slope of q against gamma, theta {:g}", theta), "> 0", growth, 0));
    j.stated.checks.push_back(above(fmt::format("excess kurtosis at the greatest gamma less the greatest other, theta {:g}", theta), "> 0", lead, 0));
    j.sharpened.checks.push_back(positive(fmt::format("slope of q against gamma, theta {:g}", theta), "> 0", growth));
    j.sharpened.checks.push_back(positive(fmt::format("excess kurtosis at the greatest gamma less the greatest other, theta {:g}", theta), "> 0", lead));
  }
  add_choices(j, results, "q in large grains", stress_of("large", "q_gaussian.q"), {{}, {}, wanted_positive()});
  add_choices(j, results, "The excess kurtosis in large grains", stress_of("large", "excess_kurtosis"), {{}, {}, wanted_positive()});
  return j;
}

}  // namespace arenite::ledger
