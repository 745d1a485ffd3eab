#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ledger/claims/claims.hpp"
#include "ledger/claims/paper_checks.hpp"
#include "ledger/claims/paper_choices.hpp"

namespace arenite::ledger {
namespace {

/// The partly filled state of a pair with the largest mean void.
struct VoidPeaks {
  PairMeans saturation, cv;              ///< there
  PairMeans above_first, above_last;     ///< mean volume less that at the least and the greatest width
};

/// The same pair; without samples if there is none.
PairMean pair_of(const PairMeans& means, const PairMean& like) {
  const auto at = std::find_if(means.begin(), means.end(), [&](const PairMean& m) { return m.gamma == like.gamma && m.theta == like.theta; });
  return at == means.end() ? PairMean{like.gamma, like.theta, full, {}, {}} : *at;
}

VoidPeaks void_peaks(const Samples& samples) {
  std::vector<PairMeans> mean, cv, saturation;
  for (const double width : samples.widths) {
    mean.push_back(pair_means(samples, "voids.mean", width));
    cv.push_back(pair_means(samples, "voids.cv", width));
    saturation.push_back(pair_means(samples, "S_m", width));
  }
  VoidPeaks peaks;
  PairMeans tops;
  for (const PairMean& m : mean.front()) {
    std::size_t best = 0;
    for (std::size_t k = 0; k < mean.size(); ++k)
      if (of_pair(mean[k], m.gamma, m.theta).value > of_pair(mean[best], m.gamma, m.theta).value) best = k;
    tops.push_back(pair_of(mean[best], m));
    peaks.cv.push_back(pair_of(cv[best], m));
    peaks.saturation.push_back(pair_of(saturation[best], m));
  }
  peaks.above_first = difference(tops, mean.front());
  peaks.above_last = difference(tops, mean.back());
  return peaks;
}

/// How far a number lies above 1, so that its distance has the error.
PairMeans less_one(PairMeans means) {
  for (PairMean& m : means) m.value.value -= 1;
  return means;
}

/// From one width to another.
PairMeans step(const Samples& samples, const char* number, double from, double to) {
  return difference(pair_means(samples, number, to), pair_means(samples, number, from));
}

std::function<Value(const Samples&)> of_pores(const char* number) {
  return [=](const Samples& samples) { return straightness(pair_means(samples, number), 6, Against::inverse_gamma); };
}

std::function<Value(const Samples&)> of_voids(const char* number) {
  return [=](const Samples& samples) { return of_pair(pair_means(samples, number, 0.6), 1.11, 2.2); };
}

}  // namespace

/// Single pores over pi rbar_L^2, five-sample means; the figure shows theta 1.4.
Judgement judge_p3(const Results& results) {
  const Samples samples = paper_samples(results);
  const PairMeans mean = pair_means(samples, "pores.mean"), deviation = pair_means(samples, "pores.deviation");
  const PairMeans peak = pair_means(samples, "pores.peak");
  const auto add_straight = [&](Verdict& v, double theta) {
    v.checks.push_back(straight("the mean pore volume", "nearly linear", mean, theta, Against::inverse_gamma));
    v.checks.push_back(straight("its standard deviation", "nearly linear", deviation, theta, Against::inverse_gamma));
  };
  Judgement j;
  add_straight(j.stated, 1.4);
  for (const double theta : thetas(mean)) add_straight(j.sharpened, theta);
  add_rises(j.stated, "pore volume at the pdf's peak", "< 0", of_theta(peak, 1.4), -1);
  add_rises(j.sharpened, "pore volume at the pdf's peak", "< 0", peak, -1);
  add_choices(j, results, "R^2 of the mean pore volume against 1/gamma, theta 6", of_pores("pores.mean"), wanted_above(0.98));
  add_choices(j, results, "R^2 of its standard deviation against 1/gamma, theta 6", of_pores("pores.deviation"), wanted_above(0.98));
  return j;
}

/// Single voids of partly filled samples against S_m, which the width of the bridges sets.
Judgement judge_p4(const Results& results) {
  const Samples samples = paper_samples(results);
  const VoidPeaks peaks = samples.runs.empty() ? VoidPeaks{} : void_peaks(samples);
  const PairMeans plain = only(peaks.cv, [](const PairMean& m) { return m.theta < 6 || m.gamma < 3.33; });
  Judgement j;
  add_range(j.stated, "S_m of the largest mean void", "0.4 to 0.7", peaks.saturation, 0.4, 0.7);
  add_range(j.sharpened, "S_m of the largest mean void", "0.4 to 0.7", peaks.saturation, 0.38, 0.6);
  add_range(j.stated, "CV there", "< 1", peaks.cv, 0, 1);
  j.sharpened.checks.push_back(in_every_pair("CV there less 1, but for theta 6 at gamma >= 3.33", "< 0", less_one(plain), -1));
  for (Verdict* v : {&j.stated, &j.sharpened}) {
    v->checks.push_back(in_all_pairs("largest mean void less that at eta 0.2", "> 0", peaks.above_first, +1));
    v->checks.push_back(in_all_pairs("largest mean void less that at eta 1", "> 0", peaks.above_last, +1));
    v->checks.push_back(in_all_pairs("CV, from eta 0.2 to 0.4", "> 0", step(samples, "voids.cv", 0.2, 0.4), +1));
    v->checks.push_back(in_all_pairs("CV, from eta 0.4 to 0.6", "< 0", step(samples, "voids.cv", 0.4, 0.6), -1));
    v->checks.push_back(in_all_pairs("CV, from eta 0.6 to 0.8", "> 0", step(samples, "voids.cv", 0.6, 0.8), +1));
    v->checks.push_back(in_all_pairs("void volume at the pdf's peak, from eta 0.4 to 0.6", "> 0", step(samples, "voids.peak", 0.4, 0.6), +1));
  }
  for (const PairMean& m : peaks.cv)
    if (m.theta == 6 && m.gamma >= 3.33) j.findings.push_back(fmt::format("At gamma {:g} and theta 6 the CV at the largest mean void is {}.", m.gamma, text_of(m.value)));
  const std::string at = ", gamma 1.11, theta 2.2, eta 0.6";
  add_choices(j, results, "CV less 1" + at, [](const Samples& s) { return difference(of_voids("voids.cv")(s), {1, 0}); }, wanted_negative());
  add_choices(j, results, "S_m" + at, of_voids("S_m"), wanted_between(0.38, 0.6));
  return j;
}

}  // namespace arenite::ledger
