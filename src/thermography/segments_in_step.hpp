#pragma once
#include "thermography/segment_sums.hpp"

namespace arenite::thermography {

/// Where the swings that the segments show, each by itself, are most in step: the frequency within `reach` of that of
/// the sums (all in Hz) to about a tenth of a cycle over the film. Looks at some thousand pixels. Films whose segments
/// are shorter than one and a half cycles keep the frequency of the sums: Newton steps reach the maximum from there.
double segments_in_step(const SegmentSums& sums, double reach);

}  // namespace arenite::thermography
