#pragma once
#include "grains/dem/stage.hpp"
#include "model/result.hpp"

namespace arenite::fields {

/// Numbers of what flows under its weight, each with its error: "discharge" of a stage that counts what passes; "surface" of one that weighs and on
/// which no side presses: angle of repose, ends, and the run-out since the state `before` (null: none); "floor" of one that lasts a time between
/// walls: pressure at the bottom. Empty where it is none of these.
Numbers flow_numbers(const StageResult& result, const dem::Stage& stage, const Packing* before);

}  // namespace arenite::fields
