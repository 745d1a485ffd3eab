#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ledger/claims/claims.hpp"
#include "ledger/claims/paper_checks.hpp"
#include "ledger/claims/paper_choices.hpp"

namespace arenite::ledger {
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

/// The greatest spread below gamma 5 over that at 5.
double relative_spread(const PairMeans& rho) {
  double below_five = statistics::unknown;
  for (const double gamma : gammas(rho))
    if (gamma < 5) below_five = std::fmax(below_five, spread(rho, gamma));
  return below_five / spread(rho, 5);
}

/// theta 2.7 beats the outer ones beyond 2 s.e., and none beats it so.
Check densest(const PairMeans& rho) {
  const Value peak = of_pair(rho, 5, 2.7);
  Check check = positive("rho_p at gamma 5: theta 2.7 less the greatest of the others", "> 0", {});
  for (const PairMean& m : rho)
    if (m.gamma == 5 && m.theta != 2.7 && !(m.value.value < peak.value - check.ours)) {
      const Value lead = difference(peak, m.value);
      check.ours = lead.value;
      check.error = lead.error;
    }
  check.tolerance = "none higher by 2 s.e., 1.4 and 6 lower by 2 s.e.";
  Verdict all;
  all.checks = {positive("", "", difference(peak, of_pair(rho, 5, 1.4))), positive("", "", difference(peak, of_pair(rho, 5, 6)))};
  if (std::isfinite(check.ours) && std::isfinite(check.error)) check.holds = check.ours > -beyond * check.error ? all.holds() : Holds::no;
  return check;
}

/// First falling, then rising: the least mean lies inside, and both ends above it beyond 2 s.e.
void add_dip(Verdict& verdict, const PairMeans& z_s) {
  for (const double theta : thetas(z_s)) {
    const Series points = against_gamma(z_s, theta);
    const auto least = std::min_element(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.mean < b.mean; });
    const auto over = [&](const Point& p) { return difference({p.mean, p.error}, {least->mean, least->error}); };
    verdict.checks.push_back(positive(fmt::format("Z_s, fall from gamma 1 to {:g}, theta {:g}", least->x, theta), "> 0", over(points.front())));
    verdict.checks.push_back(positive(fmt::format("Z_s, rise from gamma {:g} to the greatest, theta {:g}", least->x, theta), "> 0", over(points.back())));
  }
}

Check below_one(const std::string& what, const PairMeans& z_ll) {
  const auto greatest = std::max_element(z_ll.begin(), z_ll.end(), [](const PairMean& a, const PairMean& b) { return a.value.value < b.value.value; });
  if (greatest == z_ll.end()) return below(what, "< 1", {}, 1);
  return below(fmt::format("{}, greatest (gamma {:g}, theta {:g})", what, greatest->gamma, greatest->theta), "< 1", greatest->value, 1);
}

/// The mean of one pair, or its change from one gamma to another.
std::function<Value(const Samples&)> at(const char* number, double gamma, double theta) {
  return [=](const Samples& samples) { return of_pair(pair_means(samples, number), gamma, theta); };
}

std::function<Value(const Samples&)> change(const char* number, double from, double to, double theta) {
  return [=](const Samples& samples) { return difference(at(number, to, theta)(samples), at(number, from, theta)(samples)); };
}

void add_choices_p2(Judgement& j, const Results& results) {
  add_choices(j, results, "Z_l, gamma 5, theta 1.4", at("coordination.Z_l", 5, 1.4), wanted_between(3.7, 14.3));
  add_choices(j, results, "Z_l, gamma 1, theta 6", at("coordination.Z_l", 1, 6), wanted_between(3.7, 14.3));
  add_choices(j, results, "Z_s, gamma 5, theta 1.4", at("coordination.Z_s", 5, 1.4), wanted_between(2.8, 4.5));
  add_choices(j, results, "Z_s, gamma 3.33, theta 6", at("coordination.Z_s", 3.33, 6), wanted_between(2.8, 4.5));
  add_choices(j, results, "Z_s, fall from gamma 1 to 2, theta 1.6", change("coordination.Z_s", 2, 1, 1.6), wanted_positive());
  add_choices(j, results, "Z_s, fall from gamma 1 to 3.33, theta 6", change("coordination.Z_s", 3.33, 1, 6), wanted_positive());
  add_choices(j, results, "R^2 of Z_ls against gamma, theta 6", [](const Samples& samples) { return straightness(pair_means(samples, "coordination.Z_ls"), 6, Against::gamma); }, wanted_above(0.98));
}

}  // namespace

/// The share of particles among the nodes, means over samples.
Judgement judge_p1(const Results& results) {
  const Samples samples = paper_samples(results);
  const PairMeans rho = pair_means(samples, "solid_fraction");
  Judgement j;
  add_range(j.stated, "rho_p", "0.82 to 0.89", rho, 0.82, 0.89);
  add_range(j.sharpened, "rho_p", "0.82 to 0.89", rho, 0.81, 0.89);
  const Check little = below("greatest spread of rho_p over theta at a gamma below 5 over that at 5", "little", jackknifed(rho, relative_spread), 1);
  for (Verdict* v : {&j.stated, &j.sharpened}) {
    add_rises(*v, "rho_p", "> 0", rho, +1);
    v->checks.push_back(densest(rho));
    v->checks.push_back(little);
  }
  j.findings.push_back(fmt::format("At gamma 5 and theta 6 asked for, the crop has a volume ratio of {}.", text_of(of_pair(pair_means(samples, "volume_ratio"), 5, 6))));
  add_choices(j, results, "rho_p, gamma 1, theta 1.4", at("solid_fraction", 1, 1.4), wanted_between(0.81, 0.89));
  add_choices(j, results, "rho_p, gamma 5, theta 1.4", at("solid_fraction", 5, 1.4), wanted_between(0.81, 0.89));
  add_choices(j, results, "rho_p, change from gamma 1 to 5, theta 1.4", change("solid_fraction", 1, 5, 1.4), wanted_positive());
  add_choices(j, results, "rho_p, change from gamma 1 to 5, theta 6", change("solid_fraction", 1, 5, 6), wanted_positive());
  return j;
}

/// Coordination by class, surfaces nearer than the cement's gap, neighbours from the whole packing. The source gives no bound for
/// "nearly linear"; that of P3 is taken.
Judgement judge_p2(const Results& results) {
  const Samples samples = paper_samples(results);
  const auto z = [&](const char* name) { return pair_means(samples, std::string("coordination.") + name); };
  const PairMeans z_l = z("Z_l"), z_s = z("Z_s"), z_ll = z("Z_ll"), z_ls = z("Z_ls");
  Judgement j;
  add_range(j.stated, "Z_l", "4 to 14", z_l, 4, 14);
  add_range(j.stated, "Z_s", "3.1 to 4.2", z_s, 3.1, 4.2);
  add_range(j.sharpened, "Z_l", "4 to 14", z_l, 3.7, 14.3);
  add_range(j.sharpened, "Z_s", "3.1 to 4.2", z_s, 2.8, 4.5);
  j.stated.checks.push_back(below_one("Z_ll for theta <= 2.2 and gamma > 2", only(z_ll, [](const PairMean& m) { return m.theta <= 2.2 && m.gamma > 2; })));
  j.sharpened.checks.push_back(below_one("Z_ll for theta <= 1.6 and gamma >= 2.5", only(z_ll, [](const PairMean& m) { return m.theta <= 1.6 && m.gamma >= 2.5; })));
  j.sharpened.checks.push_back(below_one("Z_ll for theta 2.2 and gamma 5", only(z_ll, [](const PairMean& m) { return m.theta == 2.2 && m.gamma == 5; })));
  for (Verdict* v : {&j.stated, &j.sharpened}) {
    add_rises(*v, "Z", "> 0", z("Z"), +1);
    add_rises(*v, "Z_l", "> 0", z_l, +1);
    add_rises(*v, "Z_ls", "> 0", z_ls, +1);
    add_rises(*v, "Z_ss", "> 0", z("Z_ss"), +1);
    add_rises(*v, "Z_sl", "< 0", z("Z_sl"), -1);
    add_rises(*v, "Z_ll", "< 0", z_ll, -1);
    for (const double theta : thetas(z_ls)) v->checks.push_back(straight("Z_ls", "nearly linear; bound of P3", z_ls, theta, Against::gamma));
    add_dip(*v, z_s);
  }
  add_choices_p2(j, results);
  return j;
}

}  // namespace arenite::ledger
