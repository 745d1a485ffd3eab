#pragma once
#include <string>

#include "ledger/claim.hpp"

namespace arenite::report {

/// Whether a claim has choices whose number something is wanted of.
bool has_dots(const ledger::Judgement& judgement);

/// These numbers as an SVG: one panel a number, one row a choice, a dot with its standard error against the range that is wanted.
/// Reads on light and dark.
std::string ledger_dots(const ledger::Judgement& judgement);

}  // namespace arenite::report
