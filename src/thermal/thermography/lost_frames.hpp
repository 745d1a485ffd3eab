#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "thermal/thermography/load_phases.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

/// Frames that were lost right before one of the film.
struct LostFrames {
  std::size_t frame = 0, count = 0;
};

/// Where frames of an even film were lost: the losses by which the signal of the load, weighed as `phases` say, has one
/// frequency of the band in which that of the load is sought. They are found where they, and nothing else, make it so:
/// a load whose own frequency wanders has none. A loss of more than half a cycle is taken for the shortest that fits.
/// Film and sums are those of the same frames; empty if none were found, or `progress` stopped it.
std::vector<LostFrames> find_lost_frames(FilmSource& film, const SegmentSums& sums, const LoadPhases& phases,
                                         const Progress& progress);

/// Times of frames that follow each other after `interval` (s) but where some were lost.
std::vector<double> times_with_losses(std::size_t frames, double interval, const std::vector<LostFrames>& lost);

}  // namespace arenite::thermography
