#include <fmt/core.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "validation/claims/claims.hpp"
#include "validation/claims/paper_checks.hpp"
#include "validation/claims/paper_choices.hpp"

namespace arenite::validation {
namespace {

/// The partly filled state with the largest mean void, pair by pair.
struct VoidPeaks {
  PairMeans saturation, cv;           ///< there
  PairMeans above_first, above_last;  ///< mean volume less that at the least and the greatest width
};

VoidPeaks void_peaks(const Samples& samples) {
  std::vector<PairMeans> mean, cv, saturation;
  for (const double width : samples.widths) {
    mean.push_back(pair_means(samples, "voids.mean", width));
    cv.push_back(pair_means(samples, "voids.cv", width));
    saturation.push_back(pair_means(samples, "S_m", width));
  }
  const PairMeans tops = at_greatest(mean, mean);
  return {at_greatest(mean, saturation), at_greatest(mean, cv), difference(tops, mean.front()),
          difference(tops, mean.back())};
}

/// From one width to another.
Family step(const Samples& samples, const char* number, double from, double to) {
  return members(difference(pair_means(samples, number, to), pair_means(samples, number, from)));
}

std::function<Value(const Samples&)> of_pores(const char* number) {
  return [=](const Samples& samples) { return straightness(pair_means(samples, number), 6, Against::inverse_gamma); };
}

std::function<Value(const Samples&)> of_voids(const char* number, double gamma, double theta) {
  return [=](const Samples& samples) { return of_pair(pair_means(samples, number, 0.6), gamma, theta); };
}

}  // namespace

/// Single pores over pi rbar_L^2, five-sample means.
Judgement judge_p3(const Results& results) {
  const Samples samples = paper_samples(results);
  const PairMeans mean = pair_means(samples, "pores.mean"), deviation = pair_means(samples, "pores.deviation");
  const PairMeans peak = pair_means(samples, "pores.peak");
  Judgement j;
  j.checks = {straight("the mean pore volume", "nearly linear", mean, Against::inverse_gamma),
              straight("its standard deviation", "nearly linear", deviation, Against::inverse_gamma),
              with_gamma("the mean pore volume", "falls", mean, -1),
              with_gamma("its standard deviation", "falls", deviation, -1),
              with_gamma("pore volume at the peak of the pdf", "falls", peak, -1)};
  draw_packings_alone(j);
  add_choices(j, results, "R^2 of the mean pore volume against 1/gamma, theta 6", of_pores("pores.mean"),
              wanted_above(0.98));
  add_choices(j, results, "R^2 of its standard deviation against 1/gamma, theta 6", of_pores("pores.deviation"),
              wanted_above(0.98));
  return j;
}

/// Single voids of partly filled samples against S_m, which the width of the bridges sets.
Judgement judge_p4(const Results& results) {
  const Samples samples = paper_samples(results);
  const VoidPeaks peaks = samples.runs.empty() ? VoidPeaks{} : void_peaks(samples);
  const PairMeans plain = only(peaks.cv, [](const PairMean& m) { return m.theta < 6 || m.gamma < 3.33; });
  Judgement j;
  j.checks = {number(in_range("S_m of the largest mean void", "medium", peaks.saturation, 0.38, 0.6)),
              on_the_whole("largest mean void minus that at eta 0.2", "peaks", members(peaks.above_first), +1),
              on_the_whole("largest mean void minus that at eta 1", "peaks", members(peaks.above_last), +1),
              on_the_whole("CV of voids, from eta 0.2 to 0.4", "rises", step(samples, "voids.cv", 0.2, 0.4), +1),
              on_the_whole("CV of voids, from eta 0.4 to 0.6", "drops", step(samples, "voids.cv", 0.4, 0.6), -1),
              on_the_whole("CV of voids, from eta 0.6 to 0.8", "rises again", step(samples, "voids.cv", 0.6, 0.8), +1),
              every("CV at the largest mean void, except theta 6 at gamma >= 3.33", "< 1", members(plain), {.high = 1}),
              number(every("CV at the largest mean void", "< 1", members(peaks.cv), {.high = 1})),
              on_the_whole("void volume at the peak of the pdf, from eta 0.4 to 0.6",
                           "the peak at small voids vanishes", step(samples, "voids.peak", 0.4, 0.6), +1)};
  for (const auto& [gamma, theta] : {std::pair{5.0, 6.0}, {1.11, 2.2}}) {
    const std::string at = fmt::format(", gamma {}, theta {}, eta 0.6", gamma, theta);
    add_choices(j, results, "CV of voids" + at, of_voids("voids.cv", gamma, theta), wanted_below(1));
    add_choices(j, results, "S_m" + at, of_voids("S_m", gamma, theta), wanted_between(0.38, 0.6));
  }
  return j;
}

}  // namespace arenite::validation
