#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/claims.hpp"
#include "ledger/claims/paper_checks.hpp"
#include "ledger/claims/paper_choices.hpp"
#include "ledger/claims/paper_loads.hpp"

namespace arenite::ledger {
namespace {

PairMeans classed(const PairMeans& means) {
  return only(means, [](const PairMean& m) { return m.gamma >= 1.43; });
}

PairMeans small_less_large(const Samples& samples) { return difference(stress_means(samples, "small", "variance"), stress_means(samples, "large", "variance")); }

void add_sides_of_the_mean(Verdict& verdict, const Samples& samples) {
  add_range(verdict, "mean in the matrix", "< 1", stress_means(samples, "matrix", "mean_over_sample_mean"), 0, 1);
  add_range(verdict, "mean in large grains", "> 1", stress_means(samples, "large", "mean_over_sample_mean"), 1, 2);
}

Verdict sharpened_p5(const Samples& samples) {
  Verdict v;
  add_range(v, "99.99 % quantile over the mean", "2", stress_means(samples, "all", "quantiles.99.99 %"), 1.8, 2.2);
  add_sides_of_the_mean(v, samples);
  v.checks.push_back(in_all_pairs("variance in small less that in large grains, gamma >= 1.43", "> 0", classed(small_less_large(samples)), +1));
  return v;
}

/// From the least to the greatest gamma, and the end.
struct Fall {
  std::string at;
  Value change, end;
};
std::vector<Fall> falls_in_small(const Samples& samples) {
  const PairMeans small = stress_means(samples, "small", "mean_over_sample_mean");
  std::vector<Fall> falls;
  for (const double theta : thetas(small)) {
    const Series points = against_gamma(small, theta);
    if (points.empty()) continue;
    falls.push_back({fmt::format(", theta {:g}", theta), rise(points), {points.back().mean, points.back().error}});
  }
  return falls;
}

Verdict sharpened_p6(const Samples& samples) {
  Verdict v;
  add_range(v, "mean in large grains", "about 1.07", stress_means(samples, "large", "mean_over_sample_mean"), 1.04, 1.10);
  for (const Fall& fall : falls_in_small(samples)) {
    v.checks.push_back(below("mean in small grains, change from gamma 1 to 5" + fall.at, "< 0", fall.change, -0.04));
    v.checks.push_back(within("mean in small grains at gamma 5" + fall.at, fall.end, 1, 0.04));
  }
  return v;
}

/// Slope and R^2 of a line with all points alike.
double plain_slope(Series points) {
  for (Point& p : points) p.error = statistics::unknown;
  return slope(points).value;
}

double straight_slope(const std::vector<PairMeans>& xy) { return plain_slope(against(xy[0], xy[1])); }
double straight_r2(const std::vector<PairMeans>& xy) { return line_r2(against(xy[0], xy[1])); }

/// Variance in large grains against the scatter of pores: the abscissa and the ordinate.
std::vector<PairMeans> variance_by_pores(const Samples& samples) { return {pair_means(samples, "pores.deviation"), stress_means(samples, "large", "variance")}; }

Value when_three(const std::vector<PairMeans>& xy, double (*number)(const std::vector<PairMeans>&)) {
  return against(xy[0], xy[1]).size() < 3 ? Value() : jackknifed(xy, number);
}

Value line_through_all(const Samples& samples) { return when_three(variance_by_pores(samples), straight_r2); }

Check one_line(const Samples& samples) {
  Check line = above("R^2 of one line through all pairs", "linear", line_through_all(samples), 0.9);
  line.tolerance = ">= 0.9";
  return line;
}

/// Slope at one theta over that of all pairs.
Value relative_slope(const std::vector<PairMeans>& xy, double theta) {
  if (against(of_theta(xy[0], theta), xy[1]).size() < 3) return {};
  return jackknifed(xy, [=](const std::vector<PairMeans>& some) { return straight_slope({of_theta(some[0], theta), some[1]}) / straight_slope(some); });
}

Verdict sharpened_p7(const Samples& samples) {
  const auto xy = variance_by_pores(samples);
  Verdict v;
  v.checks.push_back(one_line(samples));
  const auto all = thetas(xy[0]);
  if (all.size() > 1)
    for (const double theta : all) v.checks.push_back(within(fmt::format("slope at theta {:g} over that of all", theta), relative_slope(xy, theta), 1, 0.3));
  return v;
}

Value rank_with_contacts(const Samples& samples) {
  return when_three({pair_means(samples, "coordination.Z_ls"), stress_means(samples, "large", "variance")},
                    [](const std::vector<PairMeans>& xy) { return spearman(against(xy[0], xy[1])); });
}

Verdict sharpened_p8(const Samples& samples) {
  Check strong = below("rank correlation of variance and Z_ls over all pairs", "falls", rank_with_contacts(samples), -0.85);
  strong.tolerance = "<= -0.85";
  return {{strong}};
}

std::function<Value(const Samples&)> at(const char* set, const char* statistic, double gamma, double theta) {
  return [=](const Samples& samples) { return of_pair(stress_means(samples, set, statistic), gamma, theta); };
}

}  // namespace

/// Stress over the sample's mean in full samples.
Judgement judge_p5(const Results& results) {
  const Samples samples = paper_samples(results);
  const auto of_all = [&](const char* statistic) { return stress_means(samples, "all", statistic); };
  Judgement j;
  add_range(j.stated, "largest node over the mean", "2", of_all("maximum"), 1.8, 2.2);
  add_sides_of_the_mean(j.stated, samples);
  j.stated.checks.push_back(in_all_pairs("variance in small less that in large grains", "> 0", small_less_large(samples), +1));
  j.sharpened = sharpened_p5(samples);
  j.findings.push_back(fmt::format("The 99.99 % quantile is {} in the mean over pairs, the largest node {}.", text_of(overall(of_all("quantiles.99.99 %"))), text_of(overall(of_all("maximum")))));
  add_compression(j, results);
  add_shear(j, results, sharpened_p5);
  for (const double gamma : {1.0, 5.0})
    add_choices(j, results, fmt::format("99.99 % quantile over the mean, gamma {:g}, theta 1.4", gamma), at("all", "quantiles.99.99 %", gamma, 1.4), wanted_between(1.8, 2.2));
  add_choices(j, results, "Variance in small less that in large grains, gamma 5, theta 1.4", [](const Samples& s) { return of_pair(small_less_large(s), 5, 1.4); }, wanted_positive());
  return j;
}

/// Means by class in full samples.
Judgement judge_p6(const Results& results) {
  const Samples samples = paper_samples(results);
  Judgement j;
  add_range(j.stated, "mean in large grains", "about 1.07", stress_means(samples, "large", "mean_over_sample_mean"), 1.04, 1.10);
  for (const Fall& fall : falls_in_small(samples)) {
    j.stated.checks.push_back(negative("mean in small grains, change from gamma 1 to 5" + fall.at, "< 0", fall.change));
    j.stated.checks.push_back(below("mean in small grains at gamma 5" + fall.at, "< 1", fall.end, 1));
  }
  j.sharpened = sharpened_p6(samples);
  add_shear(j, results, sharpened_p6);
  for (const double theta : {1.4, 6.0}) {
    const auto small = [=](double gamma) { return at("small", "mean_over_sample_mean", gamma, theta); };
    add_choices(j, results, fmt::format("Mean in small grains at gamma 5, theta {:g}", theta), small(5), wanted_within(1, 0.04));
    add_choices(j, results, fmt::format("Mean in small grains, change from gamma 1 to 5, theta {:g}", theta), [=](const Samples& s) { return difference(small(5)(s), small(1)(s)); }, wanted_below(-0.04));
    add_choices(j, results, fmt::format("Mean in large grains at gamma 5, theta {:g}", theta), at("large", "mean_over_sample_mean", 5, theta), wanted_between(1.04, 1.10));
  }
  return j;
}

/// Variance in large grains of full samples against the scatter of single pores.
Judgement judge_p7(const Results& results) {
  const Samples samples = paper_samples(results);
  const auto xy = variance_by_pores(samples);
  Judgement j;
  j.stated.checks.push_back(one_line(samples));
  j.sharpened = sharpened_p7(samples);
  j.findings.push_back(fmt::format("One line through all pairs has a slope of {}.", text_of(when_three(xy, straight_slope))));
  for (const double theta : thetas(xy[0])) {
    const Value r2 = when_three({of_theta(xy[0], theta), xy[1]}, straight_r2);
    if (std::isfinite(r2.value)) j.findings.push_back(fmt::format("At theta {:g} the line has R^2 = {}.", theta, text_of(r2)));
  }
  add_shear(j, results, sharpened_p7);
  add_choices(j, results, "R^2 of one line through the pairs", line_through_all, wanted_above(0.9));
  return j;
}

/// Variance in large grains of full samples against their contacts with small ones.
Judgement judge_p8(const Results& results) {
  const Samples samples = paper_samples(results);
  Judgement j;
  j.stated.checks.push_back(below("rank correlation of variance and Z_ls over all pairs", "falls", rank_with_contacts(samples), 0));
  j.sharpened = sharpened_p8(samples);
  add_shear(j, results, sharpened_p8);
  add_choices(j, results, "Rank correlation of variance and Z_ls over the pairs", rank_with_contacts, wanted_below(-0.85));
  return j;
}

}  // namespace arenite::ledger
