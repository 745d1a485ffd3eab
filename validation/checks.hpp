#pragma once
#include <string>
#include <vector>

#include "validation/claim.hpp"

namespace arenite::validation {

/// Holds if the 95 % interval of `ours` (Student's t) lies in the range, fails if it lies outside; undecided where an
/// end of the range lies within it, or where the error is not known. So a range about zero asks for equivalence (two
/// one-sided tests): a difference that is merely not significant is no equality.
Outcome outcome_of(const Value& ours, const Range& range);

// Checks of one number, of the kind trend.
Check between(std::string what, std::string source, const Value& ours, double low, double high, std::string unit = "");
Check within(std::string what, const Value& ours, double source, double tolerance, std::string unit = "");
Check above(std::string what, std::string source, const Value& ours, double bound, std::string unit = "");
Check below(std::string what, std::string source, const Value& ours, double bound, std::string unit = "");
Check positive(std::string what, std::string source, const Value& ours, std::string unit = "");
Check negative(std::string what, std::string source, const Value& ours, std::string unit = "");
/// No further from zero than the margin.
Check equivalent(std::string what, std::string source, const Value& ours, double margin, std::string unit = "");
/// Other than zero by more than nothing: fails where the whole interval lies within the margin, significant or not, and
/// holds where it lies on one side of zero and reaches beyond the margin. No value does both.
Check differs(std::string what, std::string source, const Value& ours, double margin, std::string unit = "");

/// The same check of another kind.
Check as(Kind kind, Check check);
inline Check number(Check check) { return as(Kind::number, std::move(check)); }
inline Check beside(Check check) { return as(Kind::beside, std::move(check)); }
/// Made surer by further seeds of these runs.
Check drawn(std::vector<Draw> draws, Check check);
/// Decided by that, where it is not as wanted.
Check decided_by(Decider decider, Check check);
/// As a sentence begins; a symbol (a_c) stays as it is.
std::string capital(std::string text);

/// A value that nothing is wanted of.
Check reported(std::string what, const Value& ours, std::string unit = "");

/// Adds checks that were made under other conditions ("under law R") as reported only, and says in a finding how many
/// of them hold.
void add_beside(Judgement& judgement, const std::string& conditions, const std::vector<Check>& checks);

}  // namespace arenite::validation
