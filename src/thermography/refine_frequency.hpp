#pragma once
#include "thermography/segment_sums.hpp"

namespace arenite::thermography {

/// A frequency with its standard error, Hz.
struct FrequencyFit {
  double frequency = 0;
  double error = 0;
};

/// The frequency near that of the sums at which all pixels together swing most: first where the segments of some
/// thousand pixels are most in step, within 2 % or two cycles over the film, then Newton steps of the least-squares
/// problem of all pixels, each weighed by its noise. The noise alone sets the error: it is the Cramer-Rao bound.
/// A film that shows no swing keeps the frequency of the sums, with an error of infinity.
FrequencyFit refine_frequency(const SegmentSums& sums, int drift_order, const Team& team);

}  // namespace arenite::thermography
