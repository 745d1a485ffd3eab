#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "validation/claims/claims.hpp"
#include "validation/claims/paper_checks.hpp"
#include "validation/claims/paper_choices.hpp"
#include "validation/claims/paper_elements.hpp"
#include "validation/claims/paper_loads.hpp"
#include "validation/claims/tail_growth.hpp"
#include "validation/pooled.hpp"

namespace arenite::validation {
namespace {

constexpr double shown_theta = 1.4;  ///< of the paper's figures
constexpr const char* classes[] = {"large", "small"};

PairMeans shown(const PairMeans& means) { return of_theta(means, shown_theta); }

/// The lead of the exponential over the half-Gaussian.
PairMeans lead_of_exponential(const Samples& samples, const std::string& set, double width) {
  return stress_means(samples, set, "tail.log_likelihood_ratio", width);
}

/// Claimed at low saturation: bridges of eta 0.2 and 0.4.
bool is_low(double width) { return width < 0.5; }

/// All pairs at these widths, and their mean: cements of one packing are not independent.
struct Leads {
  Family family;
  std::vector<PairMeans> widths;
};
Leads leads(const std::vector<double>& widths, const std::function<PairMeans(double)>& of) {
  Leads found;
  for (const double width : widths) {
    found.widths.push_back(of(width));
    for (const Member& m : members(found.widths.back()))
      found.family.push_back({fmt::format("{}, eta {:g}", m.name, width), m.value});
  }
  return found;
}

Check in_all(const std::string& what, const std::string& source, const Leads& leads, int direction) {
  return on_the_whole(what, source, overall(mean_of(leads.widths)), leads.family, direction);
}

Leads leads_of_exponential(const Samples& samples, const std::string& set, bool low) {
  std::vector<double> widths;
  std::copy_if(samples.widths.begin(), samples.widths.end(), std::back_inserter(widths),
               [=](double width) { return is_low(width) == low; });
  return leads(widths, [&](double width) { return lead_of_exponential(samples, set, width); });
}

void add_exponential(std::vector<Check>& checks, const Samples& samples) {
  for (const char* set : classes) {
    checks.push_back(in_all(fmt::format("ln L of exponential minus half-Gaussian, {} grains, eta <= 0.4", set),
                            "exponential at low S_m", leads_of_exponential(samples, set, true), +1));
    checks.push_back(beside(in_all(fmt::format("ln L of exponential minus half-Gaussian, {} grains, eta > 0.4", set),
                                   "-", leads_of_exponential(samples, set, false), +1)));
  }
}

/// Slope of the tail against S_m, sample by sample: what is differently cemented shares its packing.
Value growth_with_saturation(const Samples& samples, const std::string& set, double gamma) {
  std::vector<Run> bridged;
  for (const Run& run : samples.runs)
    if (gamma_of(run) == gamma && theta_of(run) == shown_theta && cement_of(run) != full) bridged.push_back(run);
  return slope_over_seeds(bridged, "S_m", "stress." + samples.component + ".sets." + set + ".tail.slope");
}

void add_growth(std::vector<Check>& checks, const Samples& samples) {
  for (const char* set : classes) {
    Family slopes;
    for (const double gamma : gammas(shown(stress_means(samples, set, "tail.slope", samples.widths.front()))))
      slopes.push_back({fmt::format("gamma {:g}", gamma), growth_with_saturation(samples, set, gamma)});
    checks.push_back(
        every(fmt::format("slope of s against S_m, {} grains, theta 1.4", set), "grows", slopes, {.low = 0}));
    checks.push_back(
        positive(fmt::format("slope of s against gamma at high minus that at low S_m, {} grains, theta 1.4", set),
                 "grows", growth_of_effect(samples, set)));
  }
}

/// At little matrix the pdf over the matrix's own mean is highest near zero stress; at much it peaks at the mean.
void add_matrix_peak(std::vector<Check>& checks, const Samples& samples) {
  Family low, high;
  for (const double width : samples.widths) {
    const Member at{fmt::format("eta {:g}", width), overall(shown(stress_means(samples, "matrix", "peak.at", width)))};
    if (is_low(width)) low.push_back(at);
    if (width > 0.7) high.push_back(at);
  }
  checks.push_back(
      every("matrix, position of the peak of the pdf over the mean, eta <= 0.4", "no clear peak", low, {.high = 0.5}));
  checks.push_back(
      every("matrix, position of the peak of the pdf over the mean, eta >= 0.8", "near 1", high, {0.8, 1.2}));
  const auto scatter = [&](double width) { return stress_means(samples, "matrix", "own_variance", width); };
  const bool all = std::find(samples.widths.begin(), samples.widths.end(), 0.4) != samples.widths.end();
  const double from = all ? 0.4 : samples.widths.front(), to = all ? 0.8 : samples.widths.back();
  checks.push_back(on_the_whole(fmt::format("matrix, variance over its mean, from eta {:g} to {:g}", from, to),
                                "broad at low S_m", members(difference(scatter(to), scatter(from))), -1));
}

std::vector<Check> asked_p9(const Samples& samples) {
  std::vector<Check> checks;
  add_exponential(checks, samples);
  add_growth(checks, samples);
  add_matrix_peak(checks, samples);
  return checks;
}

PairMeans small_less_large(const Samples& samples, const std::string& number, double width) {
  return difference(stress_means(samples, "small", number, width), stress_means(samples, "large", number, width));
}

PairMeans matrix_above_mean(const Samples& samples, double from, double to) {
  const auto share = [&](double width) { return stress_means(samples, "matrix", "fraction_above_sample_mean", width); };
  return difference(share(to), share(from));
}

std::vector<Check> asked_p10(const Samples& samples) {
  const auto quantile = [&](double width) { return classed(small_less_large(samples, "quantiles.99.9 %", width)); };
  std::vector<double> from(samples.widths.begin(), samples.widths.end() - 1);
  const auto step = [&](double width) {
    return matrix_above_mean(samples, width, *std::upper_bound(samples.widths.begin(), samples.widths.end(), width));
  };
  return {in_all("99.9 % quantile, small minus large grains, gamma >= 1.43", "highest in small grains",
                 leads(samples.widths, quantile), +1),
          in_all("change of the fraction of matrix above the sample's mean from one width to the next",
                 "less matrix, more above", leads(from, step), -1)};
}

}  // namespace

/// Tails of the stress over the phase's own mean, from 0.1 to 0.001 of the peak.
Judgement judge_p9(const Results& results) {
  const Samples samples = paper_samples(results);
  Judgement j;
  j.checks = asked_p9(samples);
  add_shear(j, results, asked_p9);
  add_elements(j, results, asked_p9);
  for (const std::string set : classes) {
    for (const double width : {0.2, 1.0})
      for (const double gamma : {1.0, 5.0})
        add_choices(
            j, results,
            fmt::format("ln L of exponential minus half-Gaussian, {} grains, eta {:g}, gamma {:g}, theta 1.4", set,
                        width, gamma),
            [=](const Samples& s) { return of_pair(lead_of_exponential(s, set, width), gamma, shown_theta); },
            width < 0.5 ? wanted_positive() : Wanted());
    add_choices(
        j, results, "Slope of s against gamma at high minus that at low S_m, " + set + " grains, theta 1.4",
        [=](const Samples& s) { return growth_of_effect(s, set); }, wanted_positive());
  }
  return j;
}

/// Highest stresses by class, and how much of the matrix lies above the sample's mean.
Judgement judge_p10(const Results& results) {
  const Samples samples = paper_samples(results);
  Judgement j;
  j.checks = asked_p10(samples);
  for (const double width : samples.widths)
    j.checks.push_back(
        beside(on_the_whole(fmt::format("largest node, small minus large grains, eta {:g}", width),
                            "highest in small grains", members(small_less_large(samples, "maximum", width)), +1)));
  add_shear(j, results, asked_p10);
  add_elements(j, results, asked_p10);
  for (const double width : {0.2, 1.0})
    add_choices(
        j, results, fmt::format("99.9 % quantile in small minus large grains, eta {:g}, gamma 5, theta 1.4", width),
        [=](const Samples& s) { return of_pair(small_less_large(s, "quantiles.99.9 %", width), 5, shown_theta); },
        wanted_positive());
  for (const double gamma : {1.0, 5.0})
    add_choices(
        j, results,
        fmt::format("Fraction of matrix above the sample's mean, from eta 0.2 to 1, gamma {:g}, theta 1.4", gamma),
        [=](const Samples& s) { return of_pair(matrix_above_mean(s, 0.2, 1), gamma, shown_theta); }, wanted_negative());
  return j;
}

}  // namespace arenite::validation
