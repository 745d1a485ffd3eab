#include "validation/claim.hpp"

#include <algorithm>

namespace arenite::validation {
namespace {

std::size_t count(const std::vector<Check>& checks, Kind kind) {
  return static_cast<std::size_t>(
      std::count_if(checks.begin(), checks.end(), [=](const Check& c) { return c.kind == kind; }));
}

bool any(const std::vector<Check>& checks, Kind kind, Outcome outcome) {
  return std::any_of(checks.begin(), checks.end(),
                     [=](const Check& c) { return c.kind == kind && c.outcome == outcome; });
}

bool any_known(const std::vector<Check>& checks) {
  return std::any_of(checks.begin(), checks.end(), [](const Check& c) { return c.outcome != Outcome::unknown; });
}

/// The check that a verdict of `outcome` is to be looked for in: sources first, then trends, then numbers.
const Check* first_that(const std::vector<Check>& checks, Outcome outcome) {
  for (const Kind kind : {Kind::source, Kind::trend, Kind::number})
    for (const Check& check : checks)
      if (check.kind == kind && check.outcome == outcome) return &check;
  return nullptr;
}

}  // namespace

const char* word_for(Outcome outcome) {
  constexpr const char* words[] = {"holds", "fails", "undecided", "unknown"};
  return words[static_cast<int>(outcome)];
}

const char* word_for(Kind kind) {
  constexpr const char* words[] = {"trend", "number", "source", "supplementary"};
  return words[static_cast<int>(kind)];
}

const char* word_for(Decider decider) {
  constexpr const char* words[] = {"none found", "seeds",  "grid",      "protocol",
                                   "reading",    "source", "lost data", "missing runs"};
  return words[static_cast<int>(decider)];
}

const char* word_for(Verdict verdict) {
  constexpr const char* words[] = {"reproduced",     "trend reproduced, numbers not", "undecided",
                                   "not reproduced", "source inconsistent",           "not testable",
                                   "unknown"};
  return words[static_cast<int>(verdict)];
}

Verdict Judgement::verdict() const {
  if (!untestable.empty()) return any_known(checks) ? Verdict::not_testable : Verdict::unknown;
  const bool has_trend = count(checks, Kind::trend) > 0;
  if (!has_trend && count(checks, Kind::number) == 0) return Verdict::unknown;
  if (any(checks, Kind::source, Outcome::fails)) return Verdict::source_inconsistent;
  const bool numbers_fail = any(checks, Kind::number, Outcome::fails);
  if (any(checks, Kind::trend, Outcome::fails) || (!has_trend && numbers_fail)) return Verdict::not_reproduced;
  for (const Kind kind : {Kind::source, Kind::trend, Kind::number})
    if (any(checks, kind, Outcome::unknown)) return Verdict::unknown;
  if (any(checks, Kind::trend, Outcome::undecided)) return Verdict::undecided;
  if (numbers_fail) return Verdict::trend_reproduced;
  return any(checks, Kind::number, Outcome::undecided) ? Verdict::undecided : Verdict::reproduced;
}

const Check* deciding_check(const Judgement& judgement) {
  const auto& checks = judgement.checks;
  const Check* found = nullptr;
  switch (judgement.verdict()) {
    case Verdict::source_inconsistent:
    case Verdict::trend_reproduced:
    case Verdict::not_reproduced: found = first_that(checks, Outcome::fails); break;
    case Verdict::undecided: found = first_that(checks, Outcome::undecided); break;
    case Verdict::unknown: found = first_that(checks, Outcome::unknown); break;
    case Verdict::not_testable:
    case Verdict::reproduced: break;
  }
  return found || checks.empty() ? found : &checks.front();
}

std::string figure_place(const Claim& claim) {
  const std::string figure = claim.figure;
  return figure.empty() ? figure : claim.studies.front() + "/study.html#" + figure;
}

}  // namespace arenite::validation
