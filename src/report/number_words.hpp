#pragma once
#include "statistics/numbers.hpp"

namespace arenite::report {

/// What pages call numbers whose keys are not the field's words, {"sigma_yy": ["\u03c3_{yy}", ""]}, and the symbols
/// that stand beside words, {"pressure": ["pressure", "p"]}; the words of other keys are the key's own. By keys without
/// the unit at their end.
Numbers number_words();

}  // namespace arenite::report
