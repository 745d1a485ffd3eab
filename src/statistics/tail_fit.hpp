#pragma once
#include <cstddef>
#include <vector>

#include "statistics/blocked_sample.hpp"

namespace arenite::statistics {

/// Exponential fall-off exp(-s x) of the upper tail of values over their own mean (P IV.B), between two x: `low`,
/// beyond which the pdf stays below 0.1 of its peak, and `high`, where it first falls below 0.001 of it (edges of
/// pdf_bins, running mean of three bins).
struct TailFit {
  double low = unknown, high = unknown;
  std::size_t count = 0;             ///< values between them
  Estimate slope;                    ///< s by maximum likelihood of the exponential cut at both ends
  Estimate line_slope;               ///< s by a straight line through ln pdf in the bins
  double line_r2 = unknown;
  double likelihood_ratio = unknown; ///< ln L(exponential) - ln L(Gaussian about the mean), both cut at both ends
  double p_value = unknown;          ///< that the exponential's lead is chance, by its scatter between blocks, one-sided
};

/// The range of the rule above; {NaN, NaN} where there are no bins.
struct TailRange {
  double low = unknown, high = unknown;
};
TailRange tail_range(const Bins& bins, const Counts& counts);

/// Fits the tail of x. Errors come from leaving out one block at a time with the range held; `replicate_mean` is the
/// mean of x without each block (1 where x is over the mean of the rest), by which the slope is set right. Unknown for
/// fewer than 30 values or three bins.
TailFit fit_tail(const BlockedSample& sample, const BlockCounts& counts, const std::vector<double>& replicate_mean);

}  // namespace arenite::statistics
