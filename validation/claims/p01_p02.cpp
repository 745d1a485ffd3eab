#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "validation/claims/claims.hpp"
#include "validation/claims/paper_checks.hpp"
#include "validation/claims/paper_choices.hpp"
#include "validation/claims/paper_errors.hpp"

namespace arenite::validation {
namespace {

/// Greatest less least mean over theta at one gamma.
double spread(const PairMeans& means, double gamma) {
  double low = statistics::unknown, high = statistics::unknown;
  for (const PairMean& m : means)
    if (m.gamma == gamma) {
      low = std::fmin(low, m.value.value);
      high = std::fmax(high, m.value.value);
    }
  return high - low;
}

/// The spread over theta at each gamma below 5 less that at 5. Noise widens all of them alike.
Family excess_spreads(const PairMeans& rho) {
  Family family;
  if (!std::isfinite(spread(rho, 5))) return family;
  for (const double gamma : gammas(rho))
    if (gamma < 5)
      family.push_back({fmt::format("gamma {:g}", gamma),
                        jackknifed(rho, [=](const PairMeans& some) { return spread(some, gamma) - spread(some, 5); })});
  return family;
}

/// Theta 2.7 beats the outer ones, and none between beats it beyond chance.
Check densest(const PairMeans& rho) {
  const Value peak = of_pair(rho, 5, 2.7);
  Family outer, all;
  for (const PairMean& m : rho) {
    if (m.gamma != 5 || m.theta == 2.7) continue;
    all.push_back({fmt::format("theta {:g}", m.theta), difference(peak, m.value)});
    if (m.theta < 1.5 || m.theta > 5) outer.push_back(all.back());
  }
  Check check = every("rho_p at gamma 5: theta 2.7 minus that at theta 1.4 and 6", "> 0", outer, {.low = 0});
  check.wanted += ", no other denser";
  if (check.outcome != Outcome::unknown && every("", "", all, {.low = 0}).outcome == Outcome::fails)
    check.outcome = Outcome::fails;
  return check;
}

/// The mean of one pair, or its change from one gamma to another.
std::function<Value(const Samples&)> at(const char* number, double gamma, double theta) {
  return [=](const Samples& samples) { return of_pair(pair_means(samples, number), gamma, theta); };
}

std::function<Value(const Samples&)> change(const char* number, double from, double to, double theta) {
  return [=](const Samples& samples) {
    return difference(at(number, to, theta)(samples), at(number, from, theta)(samples));
  };
}

void add_choices_p2(Judgement& j, const Results& results) {
  add_choices(j, results, "Z_l, gamma 5, theta 1.4", at("coordination.Z_l", 5, 1.4), wanted_between(3.7, 14.3));
  add_choices(j, results, "Z_l, gamma 1, theta 6", at("coordination.Z_l", 1, 6), wanted_between(3.7, 14.3));
  add_choices(j, results, "Z_s, gamma 5, theta 1.4", at("coordination.Z_s", 5, 1.4), wanted_between(2.8, 4.5));
  add_choices(j, results, "Z_s, gamma 3.33, theta 6", at("coordination.Z_s", 3.33, 6), wanted_between(2.8, 4.5));
  for (const double gamma : {2.5, 5.0})
    add_choices(j, results, fmt::format("Z_ll, gamma {:g}, theta 2.2", gamma), at("coordination.Z_ll", gamma, 2.2),
                wanted_below(1));
  add_choices(j, results, "Z_s, fall from gamma 1 to 2, theta 1.6", change("coordination.Z_s", 2, 1, 1.6),
              wanted_positive());
  add_choices(j, results, "Z_s, fall from gamma 1 to 3.33, theta 6", change("coordination.Z_s", 3.33, 1, 6),
              wanted_positive());
  add_choices(
      j, results, "R^2 of Z_ls against gamma, theta 6",
      [](const Samples& samples) { return straightness(pair_means(samples, "coordination.Z_ls"), 6, Against::gamma); },
      wanted_above(0.98));
}

/// "0.826 to 0.879": the least and the greatest pair.
std::string ends_in_text(const PairMeans& means, const char* name) {
  if (means.empty()) return {};
  const auto [least, greatest] = std::minmax_element(
      means.begin(), means.end(), [](const PairMean& a, const PairMean& b) { return a.value.value < b.value.value; });
  return fmt::format("{} {} to {}", name, text_of(least->value), text_of(greatest->value));
}

}  // namespace

/// The share of particles among the nodes, means over samples. The ends are the printed ones, to their last digit.
Judgement judge_p1(const Results& results) {
  const Samples samples = paper_samples(results);
  const PairMeans rho = pair_means(samples, "solid_fraction");
  Judgement j;
  j.checks = {number(in_range("rho_p", "0.82 to 0.89", rho, 0.815, 0.895)), with_gamma("rho_p", "rises", rho, +1),
              densest(rho),
              every("spread of rho_p over theta at a gamma below 5 minus that at 5", "theta matters little",
                    excess_spreads(rho), {.high = 0})};
  draw_packings_alone(j);
  j.ours = ends_in_text(rho, "rho_p");
  if (const Value asked = of_pair(pair_means(samples, "volume_ratio"), 5, 6); std::isfinite(asked.value))
    j.findings.push_back(
        fmt::format("For a prescribed gamma of 5 and theta of 6 the crop has a volume ratio of {}.", text_of(asked)));
  add_choices(j, results, "rho_p, gamma 1, theta 1.4", at("solid_fraction", 1, 1.4), wanted_between(0.815, 0.895));
  add_choices(j, results, "rho_p, gamma 1, theta 1.6", at("solid_fraction", 1, 1.6), wanted_between(0.815, 0.895));
  add_choices(j, results, "rho_p, gamma 5, theta 1.4", at("solid_fraction", 5, 1.4), wanted_between(0.815, 0.895));
  add_choices(j, results, "rho_p, change from gamma 1 to 5, theta 1.4", change("solid_fraction", 1, 5, 1.4),
              wanted_positive());
  add_choices(j, results, "rho_p, change from gamma 1 to 5, theta 6", change("solid_fraction", 1, 5, 6),
              wanted_positive());
  return j;
}

/// Coordination by class, surfaces nearer than the cement's gap, neighbours from the whole packing. The source gives no
/// bound for "nearly linear"; that of P3 is taken.
Judgement judge_p2(const Results& results) {
  const Samples samples = paper_samples(results);
  const auto z = [&](const char* name) { return pair_means(samples, std::string("coordination.") + name); };
  const PairMeans z_l = z("Z_l"), z_s = z("Z_s"), z_ll = z("Z_ll"), z_ls = z("Z_ls");
  const auto few_large = only(
      z_ll, [](const PairMean& m) { return (m.theta <= 1.6 && m.gamma >= 2.5) || (m.theta == 2.2 && m.gamma == 5); });
  const auto as_stated = only(z_ll, [](const PairMean& m) { return m.theta <= 2.2 && m.gamma > 2; });
  Judgement j;
  j.checks = {
      number(in_range("Z_l", "4 to 14", z_l, 3.7, 14.3)),
      number(in_range("Z_s", "3.1 to 4.2", z_s, 2.8, 4.5)),
      with_gamma("Z", "rises", z("Z"), +1),
      with_gamma("Z_l", "rises", z_l, +1),
      with_gamma("Z_ls", "rises", z_ls, +1),
      with_gamma("Z_ss", "rises", z("Z_ss"), +1),
      with_gamma("Z_sl", "falls", z("Z_sl"), -1),
      with_gamma("Z_ll", "falls", z_ll, -1),
      straight("Z_ls", "nearly linear; bound of P3", z_ls, Against::gamma),
      every("Z_s at the smallest gamma minus its minimum", "first falls",
            by_theta(z_s, [&](double theta) { return dip(z_s, theta).fall; }), {.low = 0}),
      every("Z_s at the largest gamma minus its minimum", "then rises",
            by_theta(z_s, [&](double theta) { return dip(z_s, theta).rise; }), {.low = 0}),
      every("Z_ll for theta <= 1.6 and gamma >= 2.5, or theta 2.2 and gamma 5", "< 1", members(few_large), {.high = 1}),
      number(every("Z_ll for theta <= 2.2 and gamma > 2", "< 1", members(as_stated), {.high = 1}))};
  draw_packings_alone(j);
  if (!z_l.empty()) j.ours = ends_in_text(z_l, "Z_l") + ", " + ends_in_text(z_s, "Z_s");
  add_choices_p2(j, results);
  return j;
}

}  // namespace arenite::validation
