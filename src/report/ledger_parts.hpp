#pragma once
#include <string>

#include "ledger/judge.hpp"

/// What the forms of a ledger have in common.
namespace arenite::report {

/// With the unit.
std::string ours_text(const ledger::Check& check);
/// What stands beside the source's number.
std::string ours_text(const ledger::Judgement& judgement);

/// "12 of 40 runs done", "not begun", "the source's tables".
std::string progress_of(const ledger::StudyState& study);

}  // namespace arenite::report
