#include <fmt/format.h>

#include <cmath>

#include "ledger/claims/chapter4.hpp"
#include "ledger/claims/claims.hpp"
#include "ledger/claims/thesis_choices.hpp"
#include "ledger/trends.hpp"

namespace arenite::ledger {
namespace {

Check rising(const char* law, const Series& z) {
  Check check = above(fmt::format("rise of z from the least to the greatest ratio, {}", law), "0.6", rise(z), 0.2);
  check.tolerance = "> 0.2, no step down beyond 2 s.e.";
  if (check.holds == Holds::yes) check.holds = monotone(z, +1);
  return check;
}

}  // namespace

/// z(all) at 50 kN against the number ratio.
Judgement judge_t8(const Results& results) {
  Judgement judgement;
  for (const auto& [law, study] : laws_of_chapter_4) {
    const Series z = series(results, study, number_ratio(), "coordination.all");
    const Value first = z.empty() ? Value() : Value(z.front().mean, z.front().error);
    const Value last = z.size() < 2 ? Value() : Value(z.back().mean, z.back().error);
    judgement.stated.checks.push_back(within(fmt::format("z at the least ratio, {}", law), first, 4.3, 0.1));
    judgement.stated.checks.push_back(within(fmt::format("z at the greatest ratio, {}", law), last, 4.9, 0.1));
    judgement.sharpened.checks.push_back(rising(law, z));
    if (z.size() > 1)
      judgement.findings.push_back(fmt::format("{}: z {} at ratio {:g}, {} at {:g}; without rattlers {} over all; mean |F_t|/F_n {}.", law, text_of(first), z.front().x, text_of(last),
                                               z.back().x, text_of(mean(results, study, "coordination.without_rattlers")),
                                               text_of(mean(results, study, "stages.load.last_state.equilibrium.mobilisation"))));
  }
  add_choices_of_ratios(judgement, results, "z", "coordination.all");
  add_choices_of_ratios(judgement, results, "z without rattlers", "coordination.without_rattlers");
  return judgement;
}

}  // namespace arenite::ledger
