#pragma once
#include "statistics/numbers.hpp"

namespace arenite::report {

/// What pictures on pages and in print have in common beside the numbers that they show: how kinds are called
/// ("kinds" of nodes, "cracks", "breaks" of bonds, "sides"), sizes that are no measure of anything, chosen so that
/// pictures are read easily ("chain", "crack"), maps ("colours") and ends ("most_stress", "beyond") of scales, prefixes
/// of units ("units"), from where space is seen at first ("look") and lit ("light"), and the colours of what comes back
/// to where it began ("cyclic").
Numbers drawn();

}  // namespace arenite::report
