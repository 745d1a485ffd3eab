#pragma once
#include <cstddef>
#include <vector>

#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

/// What the phases of the load in the segments of a film show of the times of its frames.
struct LoadPhases {
  double wander = 0;               ///< root mean square of their distance from a straight line over time, rad
  double noise = 0;                ///< of it by the pixels' own noise
  std::vector<double> segment;     ///< rad, that the load has gone by there; unwrapped
  std::vector<std::size_t> pixel;  ///< some pixels, and
  std::vector<double> weight;  ///< by which their values add up to the load's signal, free of what all of them share
};

/// Of a film whose segments show the load each by itself; nothing of one whose segments do not.
LoadPhases load_phases(const SegmentSums& sums);

}  // namespace arenite::thermography
