#pragma once
#include <string>

#include "validation/claim.hpp"

namespace arenite::validation {

/// Whether a claim has choices whose number something is wanted of.
bool has_dots(const validation::Judgement& judgement);

/// These numbers as an SVG: one panel a number, one row a choice, a dot with its standard error against the range that
/// is wanted. Reads on light and dark.
std::string ledger_dots(const validation::Judgement& judgement);

}  // namespace arenite::validation
