#pragma once
#include <optional>

#include "core/threads.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/harmonic_fit.hpp"
#include "thermal/thermography/refine_frequency.hpp"
#include "thermal/thermography/segment_sums.hpp"
#include "thermal/thermography/watched_pixels.hpp"

namespace arenite::thermography {

/// Throws InputError for a film of so few cycles that drift can do nearly all that the load does.
void refuse_too_few_cycles(const HarmonicFit& fit, const SegmentSums& sums);

/// Gives the maps what distinguishes a load at their frequency from noise: its ratio, chance, share in one phase, the
/// frequency's error and at which other frequency the film oscillates. Throws InputError where the frequency was
/// `refined` on the film and nothing is found there but at another, or is a multiple of one with a far larger
/// amplitude.
void judge_amplitude(const SegmentSums& sums, const HarmonicFit& fit, const std::optional<FrequencyFit>& refined,
                     const WatchedPixels& watched, const ThreadPool& pool, LockinMaps& maps);

/// Whether pixels oscillate at the maps' frequency as a load makes them: in one phase, and more than noise does once in
/// a hundred films.
bool shows_load(const LockinMaps& maps);

}  // namespace arenite::thermography
