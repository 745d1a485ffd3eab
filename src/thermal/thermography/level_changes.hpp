#pragma once
#include <cstddef>
#include <vector>

#include "core/threads.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

/// Changes of the pixels' levels that neither the load nor a polynomial of this order in time makes, as the watched
/// pixels show them: jumps (a camera's shutter and the offsets that it sets anew), alike in all pixels or with each its
/// own, and a course that all pixels share (a camera that warms up). Jumps nearer than two cycles to each other, or one
/// to the film's ends, are not told apart; a course is one only where it is far slower than 1/f noise would be. Nothing
/// in films of few cycles. `frequency` of the load, Hz.
LevelChanges find_level_changes(const SegmentSums& sums, double frequency, int drift_order, const ThreadPool& pool);

/// The functions of time that pixels with these changes follow, one value a frame, 0 on the mean: steps, then the
/// course.
std::vector<std::vector<double>> functions_of(const LevelChanges& changes, std::size_t frames);

}  // namespace arenite::thermography
