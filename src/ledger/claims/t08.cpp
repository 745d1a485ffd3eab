#include <fmt/format.h>

#include "ledger/claims/claims.hpp"
#include "ledger/trends.hpp"

namespace arenite::ledger {
namespace {

Series coordination(const Results& results, const char* study) { return series(results, study, swept("populations.1.ratio"), "coordination.all"); }

Check rising(const char* law, const Series& z) {
  Check check = above(fmt::format("rise of z from the least to the greatest ratio, {}", law), "0.6", rise(z), 0.2);
  check.tolerance = ">= 0.2, no step down beyond 2 s.e.";
  if (check.holds == Holds::yes) check.holds = monotone(z, +1);
  return check;
}

}  // namespace

/// z(all) at 50 kN against the number ratio.
Judgement judge_t8(const Results& results) {
  const Series spring = coordination(results, "thesis-ch4"), regularised = coordination(results, "thesis-ch4-r");
  Judgement judgement;
  for (const auto& [law, z] : {std::pair{"law S", spring}, {"law R", regularised}}) {
    const Value first = z.empty() ? Value() : Value(z.front().mean, z.front().error);
    const Value last = z.empty() ? Value() : Value(z.back().mean, z.back().error);
    judgement.stated.checks.push_back(within(fmt::format("z at ratio 1, {}", law), first, 4.3, 0.1));
    judgement.stated.checks.push_back(within(fmt::format("z at ratio 10, {}", law), last, 4.9, 0.1));
    judgement.sharpened.checks.push_back(rising(law, z));
  }
  return judgement;
}

}  // namespace arenite::ledger
