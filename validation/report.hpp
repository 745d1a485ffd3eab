#pragma once
#include <string>
#include <vector>

#include "validation/judge.hpp"

namespace arenite::validation {

/// A ledger for people at a terminal: claim by claim its verdict, what decides it, and line by line what it rests on.
std::string ledger_text(const validation::Ledger& ledger);

/// For programs: {"studies": {NAME: {"runs", "done", "first_day", "last_day"}}, "claims": {ID: {"verdict": "undecided",
/// "decider": "seeds", "checks": [...], ...}}}.
std::string ledger_json(const validation::Ledger& ledger);

/// A page of Markdown: a table with one row a claim; then a section for each claim that is not simply reproduced, with
/// the checks that do not hold and its picture in the folder `pictures`, as a link from the page has it.
std::string ledger_page(const validation::Ledger& ledger, const std::string& pictures);

/// All checks and all choices, one row each, as CSV.
std::string ledger_csv(const validation::Ledger& ledger);

/// The verdicts alone as a table: a row "of,SIZE", then "ID,reproduced" for each claim. `small`: of the small studies.
std::string ledger_verdicts(const validation::Ledger& ledger, bool small);

/// One sentence for each verdict of the ledger that differs from those of `expected`, as ledger_verdicts() writes them,
/// in either direction. Throws InputError, naming `file`, for anything else, and for verdicts of studies of the other
/// size.
std::vector<std::string> changed_verdicts(const validation::Ledger& ledger, const std::string& expected,
                                          const std::string& file, bool small);

}  // namespace arenite::validation
