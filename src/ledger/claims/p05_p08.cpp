#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ledger/claims/claims.hpp"
#include "ledger/claims/paper_runs.hpp"

namespace arenite::ledger {
namespace {

PairMeans of(const Results& results, const char* set, const char* statistic) { return pair_means(results, stress_of(set, statistic), full); }

PairMeans classed(const PairMeans& means) {
  return only(means, [](const PairMean& m) { return m.gamma >= 1.43; });
}

/// y against x over pairs.
Series against(const PairMeans& x, const PairMeans& y) {
  Series points;
  for (const PairMean& m : x)
    if (const Value v = of_pair(y, m.gamma, m.theta); std::isfinite(v.value)) points.push_back({m.value.value, v.value, v.error, 1});
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  return points;
}

/// Slope of a line with all points alike.
double plain_slope(Series points) {
  for (Point& p : points) p.error = statistics::unknown;
  return slope(points).value;
}

}  // namespace

/// Stress over the sample's mean in full samples.
Judgement judge_p5(const Results& results) {
  const PairMeans large = of(results, "large", "mean_over_sample_mean"), matrix = of(results, "matrix", "mean_over_sample_mean");
  const PairMeans wider = difference(of(results, "small", "variance"), of(results, "large", "variance"));
  Judgement j;
  add_range(j.stated, "largest node over the mean", "2", of(results, "all", "maximum"), 1.8, 2.2);
  add_range(j.sharpened, "99.99 % quantile over the mean", "2", of(results, "all", "quantiles.99.99 %"), 1.8, 2.2);
  for (Verdict* v : {&j.stated, &j.sharpened}) {
    add_range(*v, "mean in the matrix", "< 1", matrix, 0, 1);
    add_range(*v, "mean in large grains", "> 1", large, 1, 2);
  }
  j.stated.checks.push_back(in_all_pairs("variance in small less that in large grains", "> 0", wider, +1));
  j.sharpened.checks.push_back(in_all_pairs("variance in small less that in large grains, gamma >= 1.43", "> 0", classed(wider), +1));
  j.findings.push_back(fmt::format("The 99.99 % quantile is {} in the mean over pairs, the largest node {}.", text_of(overall(of(results, "all", "quantiles.99.99 %"))),
                                   text_of(overall(of(results, "all", "maximum")))));
  add_choices(j, results, "The 99.99 % quantile", stress_of("all", "quantiles.99.99 %"), {wanted_between(1.8, 2.2), wanted_between(1.8, 2.2), {}});
  return j;
}

/// Means by class in full samples.
Judgement judge_p6(const Results& results) {
  const PairMeans large = of(results, "large", "mean_over_sample_mean"), small = of(results, "small", "mean_over_sample_mean");
  Judgement j;
  add_range(j.stated, "mean in large grains", "about 1.07", large, 1.04, 1.10);
  add_range(j.sharpened, "mean in large grains", "about 1.07", large, 1.04, 1.10);
  for (const double theta : thetas(small)) {
    const Series points = against_gamma(small, theta);
    const Value change = rise(points);
    const Value end{points.back().mean, points.back().error};
    const std::string at = fmt::format(", theta {:g}", theta);
    j.stated.checks.push_back(negative("mean in small grains, change from gamma 1 to 5" + at, "< 0", change));
    j.stated.checks.push_back(below("mean in small grains at gamma 5" + at, "< 1", end, 1));
    j.sharpened.checks.push_back(below("mean in small grains, change from gamma 1 to 5" + at, "< 0", change, -0.04));
    j.sharpened.checks.push_back(within("mean in small grains at gamma 5" + at, end, 1, 0.04));
  }
  add_choices(j, results, "The mean in small grains", stress_of("small", "mean_over_sample_mean"), {{}, wanted_within(1, 0.04), wanted_below(-0.04)});
  return j;
}

/// Variance in large grains of full samples against the scatter of single pores.
Judgement judge_p7(const Results& results) {
  const PairMeans x = pair_means(results, "pores.deviation", full), y = of(results, "large", "variance");
  const Series all = against(x, y);
  const double pooled = all.size() < 3 ? statistics::unknown : plain_slope(all);
  Judgement j;
  Check line = above("R^2 of one line through all pairs", "linear", all.size() < 3 ? Value() : Value(line_r2(all)), 0.9);
  line.tolerance = ">= 0.9";
  j.stated.checks.push_back(line);
  j.sharpened.checks.push_back(line);
  j.findings.push_back(fmt::format("One line through all pairs has a slope of {:.4g}.", pooled));
  for (const double theta : thetas(x)) {
    const auto mine = [&](const PairMean& m) { return m.theta == theta; };
    const Series points = against(only(x, mine), y);
    const double own = points.size() < 3 ? statistics::unknown : plain_slope(points);
    j.sharpened.checks.push_back(within(fmt::format("slope at theta {:g} over that of all", theta), {own / pooled}, 1, 0.3));
    if (points.size() >= 3) j.findings.push_back(fmt::format("At theta {:g} the line has R^2 = {:.3f}.", theta, line_r2(points)));
  }
  add_choices(j, results, "The variance in large grains", stress_of("large", "variance"));
  return j;
}

/// Variance in large grains of full samples against their contacts with small ones.
Judgement judge_p8(const Results& results) {
  const Series points = against(pair_means(results, "coordination.Z_ls", full), of(results, "large", "variance"));
  const double rank = points.size() < 3 ? statistics::unknown : spearman(points);
  Judgement j;
  j.stated.checks.push_back(below("rank correlation of variance and Z_ls over all pairs", "falls", {rank}, 0));
  Check strong = below("rank correlation of variance and Z_ls over all pairs", "falls", {rank}, -0.85);
  strong.tolerance = "<= -0.85";
  j.sharpened.checks.push_back(strong);
  add_choices(j, results, "Z_ls", "coordination.Z_ls");
  return j;
}

}  // namespace arenite::ledger
