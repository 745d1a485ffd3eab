#include <fmt/core.h>

#include <cmath>

#include "validation/claims/claims.hpp"
#include "validation/claims/paper_checks.hpp"
#include "validation/claims/paper_choices.hpp"
#include "validation/claims/paper_elements.hpp"
#include "validation/claims/paper_errors.hpp"
#include "validation/claims/paper_loads.hpp"

namespace arenite::validation {
namespace {

PairMeans small_less_large(const Samples& samples) {
  return difference(stress_means(samples, "small", "variance"), stress_means(samples, "large", "variance"));
}

std::vector<Check> asked_p5(const Samples& samples) {
  return {in_range("99.99 % quantile of stress over the mean", "about 2",
                   stress_means(samples, "all", "quantiles.99.99 %"), 1.8, 2.2),
          every("mean stress in the matrix", "< 1", members(stress_means(samples, "matrix", "mean_over_sample_mean")),
                {.high = 1}),
          every("mean stress in large grains", "> 1", members(stress_means(samples, "large", "mean_over_sample_mean")),
                {.low = 1}),
          on_the_whole("variance in small minus that in large grains, gamma >= 1.43", "large narrower",
                       members(classed(small_less_large(samples))), +1)};
}

/// The change that the slope gives between the least and the greatest gamma.
Value change_with_gamma(const PairMeans& means, double theta) {
  const Series points = against_gamma(means, theta);
  return points.size() < 2 ? Value() : weighted_sum({{points.back().x - points.front().x, slope(points)}});
}

/// The pairs at the greatest gamma of each theta.
Family at_the_end(const PairMeans& means) {
  return by_theta(means, [&](double theta) { return value_of(against_gamma(means, theta).back()); });
}

std::vector<Check> asked_p6(const Samples& samples) {
  const PairMeans large = stress_means(samples, "large", "mean_over_sample_mean"),
                  small = stress_means(samples, "small", "mean_over_sample_mean");
  return {number(in_range("mean stress in large grains", "about 1.07", large, 1.04, 1.10)),
          every("mean stress in large grains, change over the range of gamma", "any gamma",
                by_theta(large, [&](double theta) { return change_with_gamma(large, theta); }), {-0.03, 0.03}),
          with_gamma("the mean in small grains", "falls", small, -1),
          every("mean in small grains at the largest gamma", "below 1", at_the_end(small), {.high = 1})};
}

/// Slope and R^2 of a line with all points alike.
double plain_slope(Series points) {
  for (Point& p : points) p.error = statistics::unknown;
  return slope(points).value;
}

double straight_slope(const std::vector<PairMeans>& xy) { return plain_slope(against(xy[0], xy[1])); }
double straight_r2(const std::vector<PairMeans>& xy) { return line_r2(against(xy[0], xy[1])); }

/// Variance in large grains against the scatter of pores: the abscissa and the ordinate.
std::vector<PairMeans> variance_by_pores(const Samples& samples) {
  return {pair_means(samples, "pores.deviation"), stress_means(samples, "large", "variance")};
}

Value when_three(const std::vector<PairMeans>& xy, double (*number)(const std::vector<PairMeans>&)) {
  return against(xy[0], xy[1]).size() < 3 ? Value() : jackknifed(xy, number);
}

Value line_through_all(const Samples& samples) { return when_three(variance_by_pores(samples), straight_r2); }

/// Slope at one theta over that of all pairs.
Value relative_slope(const std::vector<PairMeans>& xy, double theta) {
  if (against(of_theta(xy[0], theta), xy[1]).size() < 3) return {};
  return jackknifed(xy, [=](const std::vector<PairMeans>& some) {
    return straight_slope({of_theta(some[0], theta), some[1]}) / straight_slope(some);
  });
}

std::vector<Check> asked_p7(const Samples& samples) {
  const auto xy = variance_by_pores(samples);
  std::vector<Check> checks{above("R^2 of one line through all pairs", "linear", line_through_all(samples), 0.9)};
  if (thetas(xy[0]).size() > 1)
    checks.push_back(every("slope at one theta over that of all", "one line",
                           by_theta(xy[0], [&](double theta) { return relative_slope(xy, theta); }), {0.7, 1.3}));
  return checks;
}

Value rank_with_contacts(const Samples& samples) {
  return when_three({pair_means(samples, "coordination.Z_ls"), stress_means(samples, "large", "variance")},
                    [](const std::vector<PairMeans>& xy) { return spearman(against(xy[0], xy[1])); });
}

std::vector<Check> asked_p8(const Samples& samples) {
  const Value rank = rank_with_contacts(samples);
  return {below("rank correlation of variance and Z_ls over all pairs", "falls", rank, 0),
          number(below("rank correlation of variance and Z_ls over all pairs", "close to a line in the figure", rank,
                       -0.85))};
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
  j.checks = asked_p5(samples);
  j.checks.push_back(decided_by(
      Decider::grid, number(in_range("largest node over the mean", "about 2", of_all("maximum"), 1.8, 2.2))));
  if (const Value largest = overall(of_all("maximum")); std::isfinite(largest.value)) {
    j.ours = fmt::format("over the mean: 99.99 % quantile {}, largest node {}",
                         text_of(overall(of_all("quantiles.99.99 %"))), text_of(largest));
    j.decides =
        "\"Largest\" is read as the 99.99 % quantile, because the stress of the single largest node depends on the "
        "number of nodes.";
  }
  add_compression(j, results);
  add_shear(j, results, asked_p5);
  add_elements(j, results, asked_p5);
  for (const double gamma : {1.0, 5.0})
    add_choices(j, results, fmt::format("99.99 % quantile over the mean, gamma {:g}, theta 1.4", gamma),
                at("all", "quantiles.99.99 %", gamma, 1.4), wanted_between(1.8, 2.2));
  add_choices(j, results, "Largest node over the mean, gamma 1, theta 2.2", at("all", "maximum", 1, 2.2),
              wanted_between(1.8, 2.2));
  add_choices(
      j, results, "Variance in small minus that in large grains, gamma 5, theta 1.4",
      [](const Samples& s) { return of_pair(small_less_large(s), 5, 1.4); }, wanted_positive());
  return j;
}

/// Means by class in full samples.
Judgement judge_p6(const Results& results) {
  const Samples samples = paper_samples(results);
  const PairMeans large = stress_means(samples, "large", "mean_over_sample_mean"),
                  small = stress_means(samples, "small", "mean_over_sample_mean");
  Judgement j;
  j.checks = asked_p6(samples);
  if (!large.empty() && !small.empty())
    j.ours =
        fmt::format("large grains {} (mean over pairs); small grains at gamma {:g}: {}", text_of(overall(large)),
                    gammas(small).back(),
                    text_of(overall(only(small, [&](const PairMean& m) { return m.gamma == gammas(small).back(); }))));
  add_shear(j, results, asked_p6);
  add_elements(j, results, asked_p6);
  for (const double theta : {1.4, 6.0}) {
    const auto in_small = [=](double gamma) { return at("small", "mean_over_sample_mean", gamma, theta); };
    add_choices(j, results, fmt::format("Mean in small grains at gamma 5, theta {:g}", theta), in_small(5),
                wanted_below(1));
    add_choices(
        j, results, fmt::format("Mean in small grains, change from gamma 1 to 5, theta {:g}", theta),
        [=](const Samples& s) { return difference(in_small(5)(s), in_small(1)(s)); }, wanted_negative());
    add_choices(j, results, fmt::format("Mean in large grains at gamma 5, theta {:g}", theta),
                at("large", "mean_over_sample_mean", 5, theta), wanted_between(1.04, 1.10));
  }
  return j;
}

/// Variance in large grains of full samples against the scatter of single pores.
Judgement judge_p7(const Results& results) {
  const Samples samples = paper_samples(results);
  const auto xy = variance_by_pores(samples);
  Judgement j;
  j.checks = asked_p7(samples);
  if (const Value all = when_three(xy, straight_slope); std::isfinite(all.value))
    j.ours = fmt::format("R^2 {}, slope {}", text_of(line_through_all(samples)), text_of(all));
  for (const double theta : thetas(xy[0]))
    j.checks.push_back(reported(fmt::format("R^2 of the line at theta {:g}", theta),
                                when_three({of_theta(xy[0], theta), xy[1]}, straight_r2)));
  add_shear(j, results, asked_p7);
  add_elements(j, results, asked_p7);
  add_choices(j, results, "R^2 of one line through the pairs", line_through_all, wanted_above(0.9));
  return j;
}

/// Variance in large grains of full samples against their contacts with small ones.
Judgement judge_p8(const Results& results) {
  const Samples samples = paper_samples(results);
  Judgement j;
  j.checks = asked_p8(samples);
  add_shear(j, results, asked_p8);
  add_elements(j, results, asked_p8);
  add_choices(j, results, "Rank correlation of variance and Z_ls over the pairs", rank_with_contacts,
              wanted_below(-0.85));
  return j;
}

}  // namespace arenite::validation
