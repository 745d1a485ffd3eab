#pragma once
#include <cstddef>
#include <vector>

#include "statistics/least_squares.hpp"

namespace arenite::thermography {

/// Frames first .. end - 1 in which the load is on its way between its two values; empty where it changes from one
/// frame to the next.
struct StepGap {
  std::size_t first = 0, end = 0;
  double middle = 0;  ///< s: a sudden step at this time has the same mean as the rise
};

/// The first frame after the pixels of `series` (pixels x frames, over their noise) jump most: each split is judged by
/// what polynomials of this order on both sides explain. InputError for too few frames.
std::size_t find_step(const statistics::Matrix& series, const std::vector<double>& time, int drift_order);

/// The frames next to `split`, the first frame after a step, in which the pixels of `series` (pixels x frames, over
/// their noise) are not yet at, or no more at, the level that the frames beyond have. Along the pattern of the step all
/// pixels are one signal: a frame is on the way where it is clearly further back than the mean of the next 2 to 32
/// frames, more than such means differ elsewhere on its side. Heat that flows later takes pixels the other way, back
/// from the step, and does not look like this.
StepGap find_rise(const statistics::Matrix& series, const std::vector<double>& time, std::size_t split);

}  // namespace arenite::thermography
