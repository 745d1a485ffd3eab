#pragma once
#include <vector>

#include "grains/dem/stage.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"
#include "statistics/measured.hpp"

namespace arenite::fields {

/// How fast something passes while it does so steadily.
struct Discharge {
  bool steady = false;        ///< there is a part in which the rate only fluctuates; else the rate is that between the first and the last passing
  statistics::Measured rate;  ///< of what passes, per s; its error, by blocks of the steady part, only where there is one
  double begin = statistics::unknown, end = statistics::unknown;  ///< of that part, s
};

/// From amounts passed at times, s, that never shrink: steady part without the beginning, where it sets in, and the end, where it runs dry, each cut
/// where the error of the rest is least (steady_state.hpp). Unknown where nothing passes. Throws InputError for lists of unlike lengths, numbers that
/// are not finite, and times that do not grow.
Discharge find_discharge(const std::vector<double>& time, const std::vector<double>& passed);

/// The narrowest way between two of the boundaries that are there, m; unknown where there are fewer than two.
double narrowest_opening(const Domain& domain);

/// Numbers of what flows under its weight, each with its error: "discharge" of a stage that counts what passes; "surface" of one that weighs and on
/// which no side presses: angle of repose, ends, and the run-out since the state `before` (null: none); "floor" of one that lasts a time between
/// walls: pressure at the bottom. Empty where it is none of these.
Numbers flow_numbers(const StageResult& result, const dem::Stage& stage, const Packing* before);

/// Numbers of a sample whose grains cohere: pairs joined at the end of the stage and those of them that are apart, the mean pull of touching grains
/// F_c, N, and the granular Bond number, F_c over a grain's weight, or, without gravity, over the force p d t that the pressure of the state `before`
/// puts on a grain. Where a stage draws sides apart: the largest tension on one of them, Pa, and beside it Rumpf's estimate for the state before (H.
/// Rumpf, Chem. Ing. Tech. 42, 538, 1970), in the plane phi z F_c/(pi d t): solid fraction, joined neighbours a grain, mean diameter and thickness;
/// both over that pressure as well. Empty where nothing coheres.
Numbers cohesion_numbers(const StageResult& result, const dem::Stage& stage, const Packing* before);

}  // namespace arenite::fields
