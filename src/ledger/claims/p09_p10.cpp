#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/claims.hpp"
#include "ledger/claims/paper_runs.hpp"

namespace arenite::ledger {
namespace {

constexpr double shown_theta = 1.4;    ///< of the paper's figures

PairMeans of(const Results& results, const char* set, const char* statistic, double width) {
  return pair_means(results, stress_of(set, statistic), width);
}

bool is_shown(const PairMean& m) { return m.theta == shown_theta; }

/// The lead of the exponential over the half-Gaussian, mean over the gammas.
Check leads(const Results& results, const char* set, double width, bool every_theta) {
  PairMeans lead = of(results, set, "tail.log_likelihood_ratio", width);
  if (!every_theta) lead = only(lead, is_shown);
  return positive(fmt::format("ln L of exponential less half-Gaussian, {} grains, eta {:g}, {}", set, width, every_theta ? "all pairs" : "theta 1.4"),
                  "exponential", overall(lead));
}

/// The slope of the tail against S_m, of one gamma.
Series tail_against_saturation(const Results& results, const char* set, double gamma) {
  Series points;
  for (const double width : widths) {
    const Value s = of_pair(of(results, set, "tail.slope", width), gamma, shown_theta), x = of_pair(pair_means(results, "S_m", width), gamma, shown_theta);
    if (std::isfinite(s.value)) points.push_back({x.value, s.value, s.error, 1});
  }
  return points;
}

/// Rise of the tail's slope from the least to the greatest gamma.
Value effect_of_gamma(const Results& results, const char* set, double width) {
  return rise(against_gamma(of(results, set, "tail.slope", width), shown_theta));
}

/// At little matrix the pdf over the matrix's own mean is highest near zero stress; at much it peaks at the mean.
void add_matrix_peak(Verdict& verdict, const Results& results) {
  const auto at = [&](double width) { return overall(only(of(results, "matrix", "peak.at", width), is_shown)); };
  for (const double width : {0.2, 0.4}) verdict.checks.push_back(below(fmt::format("matrix, place of the pdf's peak over its mean, eta {:g}", width), "no clear peak", at(width), 0.5));
  for (const double width : {0.8, 1.0}) verdict.checks.push_back(between(fmt::format("matrix, place of the pdf's peak over its mean, eta {:g}", width), "near 1", at(width), 0.8, 1.2));
  verdict.checks.push_back(in_all_pairs("matrix, variance over its mean, from eta 0.4 to 0.8", "< 0",
                                        difference(of(results, "matrix", "own_variance", 0.8), of(results, "matrix", "own_variance", 0.4)), -1));
}

bool classed(const PairMean& m) { return m.gamma >= 1.43; }

}  // namespace

/// Tails of the stress over the phase's own mean, from 0.1 to 0.001 of the peak.
Judgement judge_p9(const Results& results) {
  Judgement j;
  const auto all_gammas = gammas(of(results, "large", "tail.slope", widths.front()));
  for (const char* set : {"large", "small"}) {
    for (const double width : widths) {
      j.sharpened.checks.push_back(leads(results, set, width, false));
      if (width < 0.5) j.stated.checks.push_back(leads(results, set, width, false));
      j.findings.push_back(fmt::format("{}: {} over all pairs.", leads(results, set, width, true).what, text_of({leads(results, set, width, true).ours, leads(results, set, width, true).error})));
    }
    for (Verdict* v : {&j.stated, &j.sharpened}) {
      for (const double gamma : all_gammas)
        v->checks.push_back(positive(fmt::format("slope of s against S_m, {} grains, gamma {:g}", set, gamma), "> 0", slope(tail_against_saturation(results, set, gamma))));
      v->checks.push_back(positive(fmt::format("rise of s with gamma at eta 1 less that at eta 0.2, {} grains", set), "> 0",
                                   difference(effect_of_gamma(results, set, 1), effect_of_gamma(results, set, 0.2))));
    }
  }
  add_matrix_peak(j.stated, results);
  add_matrix_peak(j.sharpened, results);
  add_choices(j, results, "The tail's slope s in large grains", stress_of("large", "tail.slope"), {}, Filling::part);
  return j;
}

/// Highest stresses by class, and how much of the matrix lies above the sample's mean.
Judgement judge_p10(const Results& results) {
  Judgement j;
  for (const double width : widths) {
    const auto lead = [&](const char* number) { return difference(of(results, "small", number, width), of(results, "large", number, width)); };
    j.stated.checks.push_back(in_all_pairs(fmt::format("largest node, small less large grains, eta {:g}", width), "> 0", lead("maximum"), +1));
    j.sharpened.checks.push_back(in_all_pairs(fmt::format("99.9 % quantile, small less large grains, eta {:g}, gamma >= 1.43", width), "> 0",
                                              only(lead("quantiles.99.9 %"), classed), +1));
  }
  for (std::size_t k = 1; k < widths.size(); ++k) {
    const PairMeans change = difference(of(results, "matrix", "share_above_sample_mean", widths[k]), of(results, "matrix", "share_above_sample_mean", widths[k - 1]));
    const Check falls = in_all_pairs(fmt::format("share of matrix above the sample's mean, from eta {:g} to {:g}", widths[k - 1], widths[k]), "< 0", change, -1);
    j.stated.checks.push_back(falls);
    j.sharpened.checks.push_back(falls);
  }
  add_choices(j, results, "The 99.9 % quantile in small less large grains", [](const Run& run) {
    return run(stress_of("small", "quantiles.99.9 %")) - run(stress_of("large", "quantiles.99.9 %"));
  }, {{}, wanted_positive(), {}}, Filling::part);
  add_choices(j, results, "The share of matrix above the sample's mean", stress_of("matrix", "share_above_sample_mean"), {}, Filling::part);
  return j;
}

}  // namespace arenite::ledger
