#pragma once
#include <functional>
#include <string>
#include <vector>

#include "validation/claim.hpp"
#include "validation/results.hpp"
#include "validation/trends.hpp"

namespace arenite::validation {

/// A choice that a source leaves open, made otherwise than its study makes it: the swept values, words for them, the
/// study that has such runs, empty where it is clear, and whether it is one of the protocol, of the grid or of the
/// reading.
struct Choice {
  Where where;
  std::string text;
  std::string study = {};
  Decider kind = Decider::protocol;
};

/// Holds a number against what a claim wants of it; empty where nothing is wanted.
using Wanted = std::function<Check(const Value&)>;
/// What is wanted of a number at the least and the greatest value of a swept key, and of its change between them.
struct WantedAtEnds {
  Wanted first, last, change;
};

// Wanted, as the checks of the same names in checks.hpp.
Wanted wanted_above(double bound);
Wanted wanted_below(double bound);
Wanted wanted_between(double low, double high);
Wanted wanted_within(double source, double tolerance);
Wanted wanted_positive();
Wanted wanted_negative();
/// No further from zero than the margin.
Wanted wanted_equivalent(double margin);
/// Other than zero.
Wanted wanted_different(double margin);

/// `value` of the runs with the usual choices, and with each of `choices` instead. Nothing is added where it is not
/// known with the usual ones.
void add_sensitivity(Judgement& judgement, const std::string& what, const Choice& usual,
                     const std::vector<Choice>& choices, const std::function<Value(const Choice&)>& value,
                     const Wanted& wanted);

}  // namespace arenite::validation
