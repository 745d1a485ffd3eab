#pragma once
#include <string>
#include <vector>

#include "ledger/judge.hpp"

namespace arenite::report {

/// A ledger for people: claim by claim both verdicts, and line by line what they rest on.
std::string ledger_text(const ledger::Ledger& ledger);

/// For programs: {"studies": {NAME: {"runs", "done"}}, "claims": {ID: {"stated": "holds", "sharpened": "fails", ...}}}.
std::string ledger_json(const ledger::Ledger& ledger);

/// A section of a Markdown page: a table of the verdicts, then the claims one by one. `title` is its heading.
std::string ledger_markdown(const ledger::Ledger& ledger, const std::string& title);

/// The verdicts alone: {ID: {"stated": "holds", "sharpened": "fails"}}, one line a claim.
std::string ledger_verdicts(const ledger::Ledger& ledger);

/// One sentence for each verdict of the ledger that differs from those of `expected`, as ledger_verdicts() writes them, in
/// either direction. Throws InputError, naming `file`, for anything else.
std::vector<std::string> changed_verdicts(const ledger::Ledger& ledger, const std::string& expected, const std::string& file);

}  // namespace arenite::report
