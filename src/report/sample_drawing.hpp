#pragma once
#include <string>

#include "study/final_state.hpp"

namespace arenite::report {

/// One state as JSON for a figure: `size` of the box in mm; `x`, `y`, `r` of the grains in mm from its lower left corner,
/// `material` and 1 for those that are `glued`; with `forces` the contacts between grains `i`, `j` with their normal force `f` over
/// the mean push, otherwise `stress` of the grains over the mean.
std::string sample_drawing(const study::FinalState& state, bool forces);

}  // namespace arenite::report
