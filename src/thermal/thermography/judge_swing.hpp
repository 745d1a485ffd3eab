#pragma once
#include <optional>

#include "model/lockin_maps.hpp"
#include "thermal/thermography/harmonic_fit.hpp"
#include "thermal/thermography/refine_frequency.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

/// Throws InputError for a film of so few cycles that drift can do nearly all that the swing does.
void refuse_too_few_cycles(const HarmonicFit& fit, const SegmentSums& sums);

/// Gives the maps what tells a load's swing at their frequency from noise: its ratio, chance, share in one phase, the
/// frequency's error and where else the film swings. Throws InputError where the frequency was `refined` on the film and nothing is
/// found there but elsewhere, or is a multiple of the one at which the film swings far more.
void judge_swing(const SegmentSums& sums, const HarmonicFit& fit, const std::optional<FrequencyFit>& refined, LockinMaps& maps);

}  // namespace arenite::thermography
