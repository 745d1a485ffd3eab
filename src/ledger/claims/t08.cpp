#include <fmt/format.h>

#include <algorithm>

#include "ledger/claims/chapter4.hpp"
#include "ledger/claims/claims.hpp"
#include "ledger/claims/thesis_choices.hpp"
#include "ledger/trends.hpp"

namespace arenite::ledger {
namespace {

Check rising(const char* law, const Series& z) {
  Check check = above(fmt::format("rise of z from the least to the greatest ratio, {}", law), "0.6", rise(z), 0.2);
  check.tolerance = "> 0.2, no step down";
  if (check.holds == Holds::yes && !std::is_sorted(z.begin(), z.end(), [](const Point& a, const Point& b) { return a.mean < b.mean; })) check.holds = Holds::no;
  return check;
}

Value first_of(const Series& points) { return points.empty() ? Value() : Value(points.front().mean, points.front().error); }
Value last_of(const Series& points) { return points.size() < 2 ? Value() : Value(points.back().mean, points.back().error); }

/// z with and without loose grains, of which ratios have different shares.
std::string at_ends(const char* law, const Results& results, const char* study, const Series& z) {
  const Series bearing = series(results, study, number_ratio(), "coordination.without_rattlers"), loose = series(results, study, number_ratio(), "coordination.rattlers");
  const auto at = [&](double ratio) { return results.runs(study, {{"populations.1.ratio", fmt::format("{:g}", ratio)}}); };
  return fmt::format("{}: z {} at ratio {:g}, {} at {:g}; without rattlers {} and {}, a rise of {}; share of rattlers {} and {}; mean overlap {:.2g} and {:.2g} of a diameter; mean |F_t|/F_n {}.", law, text_of(first_of(z)), z.front().x,
                     text_of(last_of(z)), z.back().x, text_of(first_of(bearing)), text_of(last_of(bearing)), text_of(rise(bearing)), text_of(first_of(loose)), text_of(last_of(loose)),
                     mean_overlap(at(z.front().x)), mean_overlap(at(z.back().x)),
                     text_of(mean(results, study, "stages.load.last_state.equilibrium.mobilisation")));
}

}  // namespace

/// z(all) at 50 kN against the number ratio.
Judgement judge_t8(const Results& results) {
  Judgement judgement;
  for (const auto& [law, study] : laws_of_chapter_4) {
    const Series z = series(results, study, number_ratio(), "coordination.all");
    judgement.stated.checks.push_back(within(fmt::format("z at the least ratio, {}", law), first_of(z), 4.3, 0.1));
    judgement.stated.checks.push_back(within(fmt::format("z at the greatest ratio, {}", law), last_of(z), 4.9, 0.1));
    judgement.sharpened.checks.push_back(rising(law, z));
    if (z.size() > 1) judgement.findings.push_back(at_ends(law, results, study, z));
  }
  add_choices_of_ratios(judgement, results, "z", "coordination.all", {wanted_within(4.3, 0.1), wanted_within(4.9, 0.1), wanted_above(0.2)});
  add_choices_of_ratios(judgement, results, "z without rattlers", "coordination.without_rattlers");
  return judgement;
}

}  // namespace arenite::ledger
