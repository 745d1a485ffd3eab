#pragma once
#include <cstddef>
#include <vector>

#include "statistics/least_squares.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

/// Numbers by which the sums of segment k give its phasor by least squares on its mean and harmonics: columns cos, sin.
statistics::Matrix segment_fit(const SegmentSums& sums, std::size_t k);

/// Phasor of one pixel in every segment, over its spread, so that a wild pixel does not speak for all: cosines and then
/// minus sines in column `at`, sines and then cosines in the next, by which the pixel's phasor at some frequency has a
/// real and an imaginary part. `fits` are those of all segments. False for a pixel that does not change, or is no
/// number.
bool phasors_of(const SegmentSums& sums, const std::vector<statistics::Matrix>& fits, std::size_t pixel,
                statistics::Matrix& phasors, std::size_t at);

/// Whether segments are long enough, one and a half cycles, to show the load each by itself.
inline bool segments_show_load(const SegmentSums& s) {
  return s.frequency * (s.time.back() - s.time.front()) >= 1.5 * static_cast<double>(s.segments());
}

}  // namespace arenite::thermography
