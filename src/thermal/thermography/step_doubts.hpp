#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "thermal/thermography/step_sides.hpp"

namespace arenite::thermography {

/// Whether pixels jump by more than noise makes them once in a hundred films at the best of so many frames.
bool is_a_step(const StepSides& sides, std::size_t frames);

/// What a film shows against what its step is taken for, a sentence each: a load that takes time, that creeps, that
/// changes at another time than given, or once more. `series`: some pixels x frames, over their noise.
std::vector<std::string> step_doubts(const statistics::Matrix& series, const std::vector<double>& time,
                                     const StepGap& rise, const StepSides& sides, const StepOptions& options);

}  // namespace arenite::thermography
