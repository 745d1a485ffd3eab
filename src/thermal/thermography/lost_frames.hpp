#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "thermal/thermography/harmonic_fit.hpp"

namespace arenite::thermography {

/// Frames that were lost right before one of the film.
struct LostFrames {
  std::size_t frame = 0, count = 0;
};

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

/// Where frames of an even film were lost: the losses by which the signal of the load, weighed as `phases` say, has one
/// frequency of the band in which that of the load is sought. They are found where they, and nothing else, make it so:
/// a load whose own frequency wanders has none. A loss of more than half a cycle is taken for the shortest that fits.
/// Film and sums are those of the same frames; empty if none were found, or `progress` stopped it.
std::vector<LostFrames> find_lost_frames(FilmSource& film, const SegmentSums& sums, const LoadPhases& phases,
                                         const Progress& progress);

/// Times of frames that follow each other after `interval` (s) but where some were lost.
std::vector<double> times_with_losses(std::size_t frames, double interval, const std::vector<LostFrames>& lost);

}  // namespace arenite::thermography
