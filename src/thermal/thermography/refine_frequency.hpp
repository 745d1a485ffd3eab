#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

/// A frequency with its standard error, Hz.
struct FrequencyFit {
  double frequency = 0;
  double error = 0;     ///< by white noise
  double of_model = 0;  ///< by what no single frequency explains
};

/// Where a frequency is looked for: within 2 % or two cycles over the film, but never below one cycle over it or above
/// the Nyquist frequency. Below two cycles load and drift are too alike for a frequency to be found.
struct SearchBand {
  double low = 0, high = 0;  ///< Hz
  bool empty() const { return !(low < high); }
};

SearchBand search_band(const std::vector<double>& time, double frequency);

/// How many independent frequencies there are in it, with what a search between them finds more.
double frequencies_in(const SearchBand& band, const std::vector<double>& time);

/// The frequency of the band at which all pixels together have most power: first where the segments of some thousand
/// pixels are most in step or, in films of few cycles, where a fit to these pixels explains most, then Newton steps of
/// the least-squares problem of all pixels, each weighed by its noise. The error is the Cramer-Rao bound for white
/// noise. A film that shows no oscillation in the band keeps the frequency of the sums, with an error of infinity.
FrequencyFit refine_frequency(const SegmentSums& sums, int drift_order, const ThreadPool& pool);

/// Where a parabola through three values one step apart, of which the middle one is the largest, has its peak: steps
/// from the middle.
inline double peak_between(double before, double at, double after) {
  const double curve = before - 2 * at + after;
  return curve < 0 ? std::clamp(0.5 * (before - after) / curve, -0.5, 0.5) : 0;
}

}  // namespace arenite::thermography
