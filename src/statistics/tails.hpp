#pragma once
#include <cstddef>
#include <vector>

#include "statistics/histogram.hpp"
#include "statistics/numbers.hpp"

namespace arenite::statistics {

/// Exponential fall-off exp(-s x) of the upper tail of values over their own mean, x.
struct TailFit {
  double low = unknown, high = unknown;  ///< where it was fitted
  std::size_t count = 0;
  Estimate slope, line_slope;  ///< s by maximum likelihood, and by a straight line through a logarithm
  double line_r2 = unknown;
  Estimate likelihood_ratio;  ///< ln L(exponential) - ln L(Gaussian)
  double p_value = unknown;   ///< that the exponential's lead is chance (Vuong's test, one-sided)
};

/// That of x beyond 1, P = P_0 exp(s (1 - x)): maximum likelihood, straight line through ln of the cumulative, and the
/// likelihood ratio against a half-Gaussian. `sorted` rises; shares refer to all of its values. Without errors:
/// contacts of one grain and points of one cumulative depend on each other, so only blocks or other samples tell them
/// (jackknife.hpp).
TailFit exponential_tail(const std::vector<double>& sorted);

/// What falls exponentially beyond the mean, level exp(rate (1 - x)): the share of the values above x, or their density
/// (T eq. 1.4).
struct FallBeyondMean {
  double level = unknown, rate = unknown;  ///< the level at the mean, x = 1
  bool is_known() const;
  double at(double x) const;
  /// The x where it has fallen to a value.
  double where(double value) const;
};

/// Density of the weak values, k x^-alpha (T eq. 1.3).
struct WeakPowerLaw {
  double k = unknown, alpha = unknown;
  bool is_known() const;
  double at(double x) const;
};

/// Density that falls as exp(-rate x) from `low` to `high`, between which there is a share of the values.
struct CutExponential {
  double rate = unknown, low = unknown, high = unknown, share = unknown;
  bool is_known() const;
  double at(double x) const;
};

/// Weak values are those from this to 1: below, forces are those of the imbalance that is left, and a few values of
/// 1e-6 would weigh as much as a hundred others.
inline constexpr double least_weak = 0.01;

/// Exponent alpha of the power law k x^-alpha of the weak values, by maximum likelihood; unknown for fewer than two.
double weak_exponent(const std::vector<double>& sorted);

/// Share of the values above a threshold; rounding must not put those that are equal to it above it.
double share_beyond(const std::vector<double>& values, double threshold);

/// How often chance would give a lead as large or larger, by its error (Q. Vuong, Econometrica 57, 307, 1989),
/// one-sided; unknown without an error.
double chance_of_lead(const Estimate& lead);

/// From `low`, beyond which the pdf stays below 0.1 of its peak, to `high`, where it first falls below 0.001 of it (P
/// IV.B; edges of pdf_bins, running mean of three bins); {NaN, NaN} where there are no bins.
struct TailRange {
  double low = unknown, high = unknown;
};
TailRange tail_range(const Bins& bins, const Counts& counts);

/// Fits the tail of x in that range. Errors come from leaving out one block at a time with the range held;
/// `replicate_mean` is the mean of x without each block (1 where x is over the mean of the rest), by which the slope is
/// set right. Unknown for fewer than 30 values or three bins.
TailFit fit_tail(const BlockedSample& sample, const BlockCounts& counts, const std::vector<double>& replicate_mean);
Numbers numbers(const TailFit& fit);

/// Rate s of the exponential exp(-s y) on 0 <= y <= length that has this mean: the maximum-likelihood fit. Negative
/// where it rises.
double cut_exponential_rate(double mean, double length);

/// theta >= 0 of exp(-theta u^2) on a <= u <= b that is likeliest for values of this mean square; 0 where none that
/// falls is.
double cut_gaussian_rate(double mean_square, double a, double b);

/// ln of the integral of exp(-s y) over 0..length.
double log_integral_exponential(double s, double length);

/// ln of the integral of exp(-theta u^2) over a..b.
double log_integral_gaussian(double theta, double a, double b);

}  // namespace arenite::statistics
