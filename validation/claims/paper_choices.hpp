#pragma once
#include <functional>
#include <string>

#include "validation/claims/paper_runs.hpp"
#include "validation/sensitivity.hpp"

namespace arenite::validation {

/// What a check becomes with each choice that the paper leaves open (study "paper-choices"): `value` of the runs with
/// that choice, and of those of the study "paper" at the same pairs and cements. Says so where these give another
/// verdict than all pairs of the study do.
void add_choices(Judgement& judgement, const Results& results, const std::string& what,
                 const std::function<Value(const Samples&)>& value, const Wanted& wanted);

}  // namespace arenite::validation
