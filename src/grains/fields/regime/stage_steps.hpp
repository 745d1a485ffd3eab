#pragma once
#include <cstdint>
#include <span>

#include "grains/dem/stage.hpp"
#include "grains/fields/regime/prediction.hpp"

// What predictions of disks and of spheres count alike.
namespace arenite::fields {

/// Steps of a time that is an estimate, however long.
std::int64_t about_steps(double time, double time_step);

/// Time, steps and states of a stage that lasts as long as it is asked to. Throws InputError for too many steps.
void count_steps(StagePrediction& prediction, const dem::Stage& stage);

/// The settling time of a sample with these sides whose critical drag is known, s.
double settling_of(const dem::Stage& stage, std::span<const dem::SideDrive> sides, double critical, double steady_drag);

}  // namespace arenite::fields
