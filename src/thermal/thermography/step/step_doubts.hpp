#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "thermal/thermography/step/step_sides.hpp"

namespace arenite::thermography {

/// Whether pixels jump by more than noise makes them once in a hundred films at the best of so many frames.
bool is_a_step(const StepSides& sides, std::size_t frames);

/// The step of every pixel of `series` (pixels x frames): one column.
statistics::Matrix jumps_at(const statistics::Matrix& series, const StepSides& sides);

/// Share of the jumps' squares that all pixels have alike: next to 1 where a camera's level jumps, less where grains
/// warm each by its own load.
double share_alike(const statistics::Matrix& jump);

/// Where the pixels jump once more on either side, within a few frames and by a tenth of the step or more.
std::vector<StepGap> other_steps(const statistics::Matrix& series, const std::vector<double>& time,
                                 const StepSides& sides);

/// What a film shows against what its step is taken for, a sentence each: a load that takes time, that creeps, that
/// changes at another time than given, or levels that jump at other times (`jumps`, s).
std::vector<std::string> step_doubts(const std::vector<double>& time, const StepGap& rise, const StepSides& sides,
                                     const std::vector<double>& jumps, const StepOptions& options);

}  // namespace arenite::thermography
