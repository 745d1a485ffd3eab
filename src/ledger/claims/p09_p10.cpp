#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ledger/claims/claims.hpp"
#include "ledger/claims/paper_checks.hpp"
#include "ledger/claims/paper_choices.hpp"
#include "ledger/claims/paper_loads.hpp"
#include "ledger/pooled.hpp"

namespace arenite::ledger {
namespace {

constexpr double shown_theta = 1.4;    ///< of the paper's figures
constexpr const char* classes[] = {"large", "small"};

PairMeans shown(const PairMeans& means) { return of_theta(means, shown_theta); }

/// The lead of the exponential over the half-Gaussian.
PairMeans lead_of_exponential(const Samples& samples, const std::string& set, double width) { return stress_means(samples, set, "tail.log_likelihood_ratio", width); }

void add_exponential(Verdict& verdict, const Samples& samples, double up_to_width) {
  for (const char* set : classes)
    for (const double width : samples.widths)
      if (width <= up_to_width)
        verdict.checks.push_back(in_every_pair(fmt::format("ln L of exponential less half-Gaussian, {} grains, eta {:g}, theta 1.4", set, width), "exponential",
                                               shown(lead_of_exponential(samples, set, width)), +1));
}

/// How surely the exponential leads at all theta, too.
std::string leads_everywhere(const Samples& samples, const std::string& set) {
  std::size_t all = 0, sure = 0, against = 0;
  for (const double width : samples.widths)
    for (const PairMean& m : lead_of_exponential(samples, set, width)) {
      all += 1;
      sure += m.value.value > beyond * m.value.error;
      against += m.value.value < -beyond * m.value.error;
    }
  return fmt::format("In {} grains the exponential leads by 2 s.e. in {} of {} pairs and widths (all theta), and the half-Gaussian in {}.", set, sure, all, against);
}

/// Slope of the tail against S_m, sample by sample: what is differently cemented shares its packing.
Value growth_with_saturation(const Samples& samples, const std::string& set, double gamma) {
  std::vector<Run> bridged;
  for (const Run& run : samples.runs)
    if (gamma_of(run) == gamma && theta_of(run) == shown_theta && cement_of(run) != full) bridged.push_back(run);
  return slope_over_seeds(bridged, "S_m", "stress." + samples.component + ".sets." + set + ".tail.slope");
}

/// Rise of the tail's slope from the least to the greatest gamma at the widest bridges, less that at the narrowest.
Value growth_of_effect(const Samples& samples, const std::string& set) {
  const auto tail = [&](double width) { return stress_means(samples, set, "tail.slope", width); };
  return rise(against_gamma(difference(tail(samples.widths.back()), tail(samples.widths.front())), shown_theta));
}

void add_growth(Verdict& verdict, const Samples& samples) {
  for (const char* set : classes) {
    for (const double gamma : gammas(shown(stress_means(samples, set, "tail.slope", samples.widths.front()))))
      verdict.checks.push_back(positive(fmt::format("slope of s against S_m, {} grains, gamma {:g}", set, gamma), "> 0", growth_with_saturation(samples, set, gamma)));
    verdict.checks.push_back(positive(fmt::format("rise of s with gamma at eta 1 less that at eta 0.2, {} grains", set), "> 0", growth_of_effect(samples, set)));
  }
}

/// At little matrix the pdf over the matrix's own mean is highest near zero stress; at much it peaks at the mean.
void add_matrix_peak(Verdict& verdict, const Samples& samples) {
  for (const double width : samples.widths) {
    const Value at = overall(shown(stress_means(samples, "matrix", "peak.at", width)));
    const std::string what = fmt::format("matrix, place of the pdf's peak over its mean, eta {:g}", width);
    if (width < 0.5) verdict.checks.push_back(below(what, "no clear peak", at, 0.5));
    if (width > 0.7) verdict.checks.push_back(between(what, "near 1", at, 0.8, 1.2));
  }
  const auto scatter = [&](double width) { return stress_means(samples, "matrix", "own_variance", width); };
  const bool all = std::find(samples.widths.begin(), samples.widths.end(), 0.4) != samples.widths.end();
  const double from = all ? 0.4 : samples.widths.front(), to = all ? 0.8 : samples.widths.back();
  verdict.checks.push_back(in_all_pairs(fmt::format("matrix, variance over its mean, from eta {:g} to {:g}", from, to), "< 0", difference(scatter(to), scatter(from)), -1));
}

Verdict sharpened_p9(const Samples& samples) {
  Verdict v;
  add_exponential(v, samples, 1);
  add_growth(v, samples);
  add_matrix_peak(v, samples);
  return v;
}

PairMeans small_less_large(const Samples& samples, const std::string& number, double width) {
  return difference(stress_means(samples, "small", number, width), stress_means(samples, "large", number, width));
}

PairMeans matrix_above_mean(const Samples& samples, double from, double to) {
  const auto share = [&](double width) { return stress_means(samples, "matrix", "share_above_sample_mean", width); };
  return difference(share(to), share(from));
}

void add_matrix_share(Verdict& verdict, const Samples& samples) {
  for (std::size_t k = 1; k < samples.widths.size(); ++k) {
    const double from = samples.widths[k - 1], to = samples.widths[k];
    verdict.checks.push_back(in_all_pairs(fmt::format("share of matrix above the sample's mean, from eta {:g} to {:g}", from, to), "< 0", matrix_above_mean(samples, from, to), -1));
  }
}

Verdict sharpened_p10(const Samples& samples) {
  Verdict v;
  for (const double width : samples.widths)
    v.checks.push_back(in_all_pairs(fmt::format("99.9 % quantile, small less large grains, eta {:g}, gamma >= 1.43", width), "> 0",
                                    only(small_less_large(samples, "quantiles.99.9 %", width), [](const PairMean& m) { return m.gamma >= 1.43; }), +1));
  add_matrix_share(v, samples);
  return v;
}

}  // namespace

/// Tails of the stress over the phase's own mean, from 0.1 to 0.001 of the peak.
Judgement judge_p9(const Results& results) {
  const Samples samples = paper_samples(results);
  Judgement j;
  add_exponential(j.stated, samples, 0.5);
  add_growth(j.stated, samples);
  add_matrix_peak(j.stated, samples);
  j.sharpened = sharpened_p9(samples);
  for (const char* set : classes) j.findings.push_back(leads_everywhere(samples, set));
  add_shear(j, results, sharpened_p9);
  for (const std::string set : classes) {
    for (const double width : {0.2, 1.0})
      for (const double gamma : {1.0, 5.0})
        add_choices(j, results, fmt::format("ln L of exponential less half-Gaussian, {} grains, eta {:g}, gamma {:g}, theta 1.4", set, width, gamma),
                    [=](const Samples& s) { return of_pair(lead_of_exponential(s, set, width), gamma, shown_theta); }, wanted_positive());
    add_choices(j, results, "Rise of s from gamma 1 to 5 at eta 1 less that at eta 0.2, " + set + " grains, theta 1.4", [=](const Samples& s) { return growth_of_effect(s, set); }, wanted_positive());
  }
  return j;
}

/// Highest stresses by class, and how much of the matrix lies above the sample's mean.
Judgement judge_p10(const Results& results) {
  const Samples samples = paper_samples(results);
  Judgement j;
  for (const double width : samples.widths)
    j.stated.checks.push_back(in_all_pairs(fmt::format("largest node, small less large grains, eta {:g}", width), "> 0", small_less_large(samples, "maximum", width), +1));
  add_matrix_share(j.stated, samples);
  j.sharpened = sharpened_p10(samples);
  add_shear(j, results, sharpened_p10);
  for (const char* number : {"quantiles.99.9 %", "maximum"})
    for (const double width : {0.2, 1.0})
      add_choices(j, results, fmt::format("{} in small less large grains, eta {:g}, gamma 5, theta 1.4", number[0] == 'm' ? "Largest node" : "99.9 % quantile", width),
                  [=](const Samples& s) { return of_pair(small_less_large(s, number, width), 5, shown_theta); }, wanted_positive());
  for (const double gamma : {1.0, 5.0})
    add_choices(j, results, fmt::format("Share of matrix above the sample's mean, from eta 0.2 to 1, gamma {:g}, theta 1.4", gamma),
                [=](const Samples& s) { return of_pair(matrix_above_mean(s, 0.2, 1), gamma, shown_theta); }, wanted_negative());
  return j;
}

}  // namespace arenite::ledger
