#pragma once
#include "grains/dem/stage.hpp"
#include "grains/texture/texture.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"

namespace arenite::fields {

/// The end of a stage, which its statistics are of.
struct StageEnd {
  const StageResult& result;
  const dem::Stage& stage;          ///< as it was asked for; nothing drives that of a packing
  const Packing* before;            ///< the state of a loaded sample that it began with; null where none was loaded before
  const texture::Texture& texture;  ///< of its last state
};
using StageStatistic = Numbers(const StageEnd& end);

/// All numbers of a stage with states: a new statistic is one file and one word in the list of stage_numbers.cpp.
StageStatistic stage_numbers;

/// Numbers of what flows under its weight, each with its error: "discharge" of a stage that counts what passes; "surface" of one that weighs and on
/// which no side presses: angle of repose, ends, and the run-out since the state before; "floor" of one that lasts a time between walls: pressure at
/// the bottom. Empty where it is none of these.
StageStatistic flow_numbers;

/// Numbers of a sample whose grains cohere: pairs joined at the end of the stage and those of them that are apart, the mean pull of touching grains
/// F_c, N, and the granular Bond number, F_c over a grain's weight, or, without gravity, over the force p d t that the pressure of the state before
/// puts on a grain. Where a stage draws sides apart: the largest tension on one of them, Pa, and beside it Rumpf's estimate for the state before (H.
/// Rumpf, Chem. Ing. Tech. 42, 538, 1970), in the plane phi z F_c/(pi d t): solid fraction, joined neighbours a grain, mean diameter and thickness;
/// both over that pressure as well. Empty where nothing coheres.
StageStatistic cohesion_numbers;

}  // namespace arenite::fields
