#pragma once
#include <string>

#include "validation/judge.hpp"

/// What the forms of a ledger have in common.
namespace arenite::validation {

/// With the unit.
std::string ours_text(const validation::Check& check);
/// What stands beside the source's number.
std::string ours_text(const validation::Judgement& judgement);

/// "12 of 40 runs done", "not begun", "the source's tables".
std::string progress_of(const validation::StudyState& study);

}  // namespace arenite::validation
