#pragma once
#include <cstdint>

#include "grains/dem/stage.hpp"
#include "grains/fields/regime/prediction.hpp"

// What predictions of disks and of spheres count alike, and those of spheres.
namespace arenite::fields {

/// Steps of a time that is an estimate, however long.
std::int64_t about_steps(double time, double time_step);

/// Time, steps and states of a stage that lasts as long as it is asked to. Throws InputError for too many steps.
void count_steps(StagePrediction& prediction, const dem::Stage& stage);

/// The same of a stage that ends at rest: it closes, s, and settles after each increment, s.
void count_steps(StagePrediction& prediction, const dem::Stage& stage, double closing, double settling);

/// Steps, roughly, in which spheres come to rest under the drives of a stage, from where they are: as dense as they
/// then get, and settled.
std::int64_t steps_to_rest(const dem::EngineIn<3>& engine, double steady_drag, const dem::Stage& stage);

/// Time and steps of a stage of spheres that the engine has begun; the sample is `larger` times as wide as the one in
/// hand. `at_rest`: whether a stage before has brought it to rest, and so dense; then whether this one has.
StagePrediction predict_stage(const dem::EngineIn<3>& engine, double steady_drag, const dem::Stage& stage,
                              double larger, bool& at_rest);

}  // namespace arenite::fields
