#pragma once
#include <cstddef>
#include <vector>

#include "core/threads.hpp"
#include "model/lockin_maps.hpp"
#include "statistics/least_squares.hpp"

namespace arenite::thermography {

/// Jumps of the pixels' levels from one frame to the next, in what drift and load leave of pixels x frames: alike in
/// all pixels or with each its own. `cycle` of the load in frames, so many `harmonics` of which are left out of a step;
/// jumps below `least` are none. In order of the frames.
std::vector<LevelJump> level_jumps(const statistics::Matrix& left, double cycle, std::size_t harmonics, double least,
                                   const ThreadPool& pool);

}  // namespace arenite::thermography
