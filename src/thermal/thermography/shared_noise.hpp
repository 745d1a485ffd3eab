#pragma once
#include <vector>

#include "core/threads.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/harmonic_fit.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

/// Noise that all pixels share, and that the pixels of a column share, at the frequencies beside the load's that `wide`
/// has: variances of the phasors of some ten thousand pixels, parted into those of the whole picture, of columns and of
/// pixels (one-way analysis of variance). Fills in the maps' common and column errors, 0 where they are no larger than
/// independent pixels have them by chance.
void measure_shared_noise(const SegmentSums& sums, const HarmonicFit& wide, const ThreadPool& pool, LockinMaps& maps);

/// Takes that noise off the load's phasors (cosine and sine of every pixel, as in the maps), where enough pixels lie
/// off the sample: what they show at the load's frequency is noise alone. They are those whose phasors lie within their
/// own noise of one value, no larger than the shared noise makes it, and whose neighbours' do. Maps and their errors
/// follow; their common and column errors are then what is left. Returns whether
/// it did.
bool take_off_shared_noise(LockinMaps& maps, std::vector<double>& cosine, std::vector<double>& sine);

}  // namespace arenite::thermography
