#include "ledger/claim.hpp"

namespace arenite::ledger {

const char* word_for(Holds holds) {
  switch (holds) {
    case Holds::yes: return "holds";
    case Holds::no: return "fails";
    case Holds::unknown: break;
  }
  return "unknown";
}

std::string figure_place(const Claim& claim) {
  const std::string figure = claim.figure;
  return figure.empty() ? figure : claim.studies.front() + "/study.html#" + figure;
}

Holds Verdict::holds() const {
  Holds all = checks.empty() ? Holds::unknown : Holds::yes;
  for (const Check& check : checks) {
    if (check.holds == Holds::no) return Holds::no;
    if (check.holds == Holds::unknown) all = Holds::unknown;
  }
  return all;
}

}  // namespace arenite::ledger
