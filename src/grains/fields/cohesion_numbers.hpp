#pragma once
#include "grains/dem/stage.hpp"
#include "model/result.hpp"

namespace arenite::fields {

/// Numbers of a sample whose grains cohere: pairs joined at the end of the stage and those of them that are apart, the mean pull of touching grains
/// F_c, N, and the granular Bond number, F_c over a grain's weight, or, without gravity, over the force p d t that the pressure of the state `before`
/// puts on a grain. Where a stage draws sides apart: the largest tension on one of them, Pa, and beside it Rumpf's estimate for the state before (H.
/// Rumpf, Chem. Ing. Tech. 42, 538, 1970), in the plane phi z F_c/(pi d t): solid fraction, joined neighbours a grain, mean diameter and thickness;
/// both over that pressure as well. Empty where nothing coheres.
Numbers cohesion_numbers(const StageResult& result, const dem::Stage& stage, const Packing* before);

}  // namespace arenite::fields
