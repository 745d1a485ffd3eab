#pragma once
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

/// Whether segments are long enough, one and a half cycles, to show swings each by itself.
bool segments_show_swings(const SegmentSums& sums);

/// Where the swings that the segments show, each by itself, are most in step: the frequency from `low` to `high` (all in
/// Hz) to about a tenth of a cycle over the film. Looks at some thousand pixels.
double segments_in_step(const SegmentSums& sums, double low, double high);

}  // namespace arenite::thermography
