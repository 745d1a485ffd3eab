#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ledger/claims/claims.hpp"
#include "ledger/claims/paper_runs.hpp"

namespace arenite::ledger {
namespace {

Series against_inverse_gamma(const PairMeans& means, double theta) {
  Series points = against_gamma(means, theta);
  for (Point& p : points) p.x = 1 / p.x;
  std::reverse(points.begin(), points.end());
  return points;
}

Check straight(const char* what, const PairMeans& means, double theta) {
  const Series points = against_inverse_gamma(means, theta);
  Check check = above(fmt::format("R^2 of {} against 1/gamma, theta {:g}", what, theta), "nearly linear", points.size() < 3 ? Value() : Value(line_r2(points)), 0.98);
  check.tolerance = ">= 0.98, rising";
  if (check.holds == Holds::yes && rise(points).value <= 0) check.holds = Holds::no;
  return check;
}

/// The partly filled state of a pair with the largest mean void: its width, S_m and how far it stands above the ends.
struct VoidPeak {
  double gamma = 0, theta = 0, width = 0;
  Value saturation, cv;
  Value above_first, above_last;         ///< mean volume less that at the least and the greatest width
};

std::vector<VoidPeak> void_peaks(const Results& results) {
  std::vector<PairMeans> mean, cv, saturation;
  for (const double width : widths) {
    mean.push_back(pair_means(results, "voids.mean", width));
    cv.push_back(pair_means(results, "voids.cv", width));
    saturation.push_back(pair_means(results, "S_m", width));
  }
  std::vector<VoidPeak> peaks;
  for (const PairMean& m : mean.front()) {
    std::size_t best = 0;
    for (std::size_t k = 0; k < widths.size(); ++k)
      if (of_pair(mean[k], m.gamma, m.theta).value > of_pair(mean[best], m.gamma, m.theta).value) best = k;
    const Value top = of_pair(mean[best], m.gamma, m.theta);
    peaks.push_back({m.gamma, m.theta, widths[best], of_pair(saturation[best], m.gamma, m.theta), of_pair(cv[best], m.gamma, m.theta),
                     difference(top, m.value), difference(top, of_pair(mean.back(), m.gamma, m.theta))});
  }
  return peaks;
}

PairMeans of_peaks(const std::vector<VoidPeak>& peaks, Value VoidPeak::*value) {
  PairMeans means;
  for (const VoidPeak& p : peaks) means.push_back({p.gamma, p.theta, p.width, p.*value});
  return means;
}

/// From one width to another.
PairMeans step(const Results& results, const char* number, double from, double to) {
  return difference(pair_means(results, number, to), pair_means(results, number, from));
}

}  // namespace

/// Single pores over pi rbar_L^2, five-sample means; the figure shows theta 1.4.
Judgement judge_p3(const Results& results) {
  const PairMeans mean = pair_means(results, "pores.mean", full), deviation = pair_means(results, "pores.deviation", full);
  const PairMeans peak = pair_means(results, "pores.peak", full);
  Judgement j;
  j.stated.checks = {straight("the mean pore volume", mean, 1.4), straight("its standard deviation", deviation, 1.4)};
  for (const double theta : thetas(mean)) {
    j.sharpened.checks.push_back(straight("the mean pore volume", mean, theta));
    j.sharpened.checks.push_back(straight("its standard deviation", deviation, theta));
  }
  add_rises(j.stated, "pore volume at the pdf's peak", "< 0", only(peak, [](const PairMean& m) { return m.theta == 1.4; }), -1);
  add_rises(j.sharpened, "pore volume at the pdf's peak", "< 0", peak, -1);
  add_choices(j, results, "The mean pore volume", "pores.mean", {{}, {}, wanted_negative()});
  return j;
}

/// Single voids of partly filled samples against S_m, which the width of the bridges sets.
Judgement judge_p4(const Results& results) {
  const auto peaks = void_peaks(results);
  const PairMeans cv = of_peaks(peaks, &VoidPeak::cv);
  const PairMeans plain = only(cv, [](const PairMean& m) { return m.theta < 6 || m.gamma < 3.33; });
  Judgement j;
  add_range(j.stated, "S_m of the largest mean void", "0.4 to 0.7", of_peaks(peaks, &VoidPeak::saturation), 0.4, 0.7);
  add_range(j.sharpened, "S_m of the largest mean void", "0.4 to 0.7", of_peaks(peaks, &VoidPeak::saturation), 0.38, 0.6);
  add_range(j.stated, "CV there", "< 1", cv, 0, 1);
  add_range(j.sharpened, "CV there, but for theta 6 at gamma >= 3.33", "< 1", plain, 0, 1);
  for (Verdict* v : {&j.stated, &j.sharpened}) {
    v->checks.push_back(in_all_pairs("largest mean void less that at eta 0.2", "> 0", of_peaks(peaks, &VoidPeak::above_first), +1));
    v->checks.push_back(in_all_pairs("largest mean void less that at eta 1", "> 0", of_peaks(peaks, &VoidPeak::above_last), +1));
    v->checks.push_back(in_all_pairs("CV, from eta 0.2 to 0.4", "> 0", step(results, "voids.cv", 0.2, 0.4), +1));
    v->checks.push_back(in_all_pairs("CV, from eta 0.4 to 0.6", "< 0", step(results, "voids.cv", 0.4, 0.6), -1));
    v->checks.push_back(in_all_pairs("CV, from eta 0.6 to 0.8", "> 0", step(results, "voids.cv", 0.6, 0.8), +1));
    v->checks.push_back(in_all_pairs("void volume at the pdf's peak, from eta 0.4 to 0.6", "> 0", step(results, "voids.peak", 0.4, 0.6), +1));
  }
  for (const VoidPeak& p : peaks)
    if (p.theta == 6 && p.gamma >= 3.33)
      j.findings.push_back(fmt::format("At gamma {:g} and theta 6 the CV at the largest mean void is {}.", p.gamma, text_of(p.cv)));
  add_choices(j, results, "The mean void volume", "voids.mean", {}, Filling::part);
  add_choices(j, results, "The CV of void volumes", "voids.cv", {}, Filling::part);
  return j;
}

}  // namespace arenite::ledger
