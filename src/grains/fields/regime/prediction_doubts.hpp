#pragma once
#include <string>
#include <vector>

#include "grains/fields/regime/prediction.hpp"

/// What is legal in a stage, but costly or unphysical: a sentence each.
namespace arenite::fields {

/// About a time step, s, and what limits it beside the shortest collision.
std::vector<std::string> doubts_about_step(double time_step, StepLimit limit, const ShortestCollision& collision,
                                           const dem::ContactParameters& contact);

/// About a stage that is predicted.
std::vector<std::string> doubts_about(const StagePrediction& prediction, const dem::Stage& stage);

}  // namespace arenite::fields
