#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "statistics/measured.hpp"

namespace arenite::fields {

/// The part of a time series, evenly sampled, in which a quantity only fluctuates: the critical state of a sheared
/// sample, say.
struct SteadyState {
  bool settled = false;   ///< the transient ends early enough
  bool reached = false;   ///< it does, and the rest is long enough to tell its error
  std::size_t first = 0;  ///< sample with which the plateau begins
  std::size_t count = 0;  ///< samples in it
  statistics::Measured
      mean;  ///< over the plateau; the error respects correlation, NaN where too few samples are independent
  double deviation = 0;  ///< standard deviation of samples about the mean
  double samples_per_independent =
      0;                  ///< variance of the mean over that of as many independent samples; 1 for white noise
  std::size_t block = 0;  ///< samples a block, over whose means the error is taken
};

/// Mean of correlated samples and its error by block averaging (H. Flyvbjerg and H. G. Petersen, J. Chem. Phys. 91,
/// 461, 1989). Blocks are twice as long as the shortest B with B^3 > 2 n max(e_B/e_1, e_1/e_B)^4, e_B the error that
/// blocks of B give (R. M. Lee et al., Phys. Rev. E 83, 066706, 2011): that B balances the correlation left between
/// blocks, of either sign, with the scatter of an error from few of them, but since the first to pass is taken, it
/// passes too early more often than too late. The error has the freedom of the blocks less one; where fewer than six
/// blocks would be left it is NaN, or that of six where departures undo each other (e_B < e_1: the load of a servo):
/// theirs is too large at worst.
SteadyState block_average(std::span<const double> samples);

/// Standard error of the mean of departures from a load that a servo makes good later, each after longer than blocks
/// can show: sums of b departures scatter by D(b), as sqrt(b) where these are independent and by the same for any b
/// where nothing of them remains. Its power p, between 0 and 1/2, is that from windows of n/16 to those of n/6, which
/// overlap, and the error D(n/16) 16^p / n. NaN for fewer than 48 samples.
double error_of_departures(std::span<const double> samples);

/// Samples, from the first on, whose mean is the ratio of the means of a and b, |<a>/<b>|, and whose fluctuations are
/// those that its error comes from: R + (a - R b)/<b>. A mean of ratios would be another number where b fluctuates, by
/// the part of a that goes with it.
std::vector<double> about_ratio_of_means(std::span<const double> a, std::span<const double> b, std::size_t first = 0);

/// Mean of so many equal blocks at the end of a series, its error by their scatter: neighbours in time are not
/// independent.
statistics::Measured mean_of_blocks(std::span<const double> samples, std::size_t blocks);

/// From the middle on.
std::span<const double> later_half(std::span<const double> samples);
/// Mean of the later half, its error by ten blocks.
statistics::Measured late_mean(std::span<const double> samples);

/// Finds where the standard error of what remains, taken as if its batches were independent, is least (MSER-5: K. P.
/// White, M. J. Cobb and S. C. Spratt, Proc. Winter Simulation Conf. 2000, 755), cuts twice as much, for what an
/// exponential transient leaves there is a few tenths of the error still, and averages the rest. A series that drifts
/// to its end is best cut at the limit, half of it, and so has not reached a steady state: its numbers are those of the
/// part after the limit. Throws InputError for samples that are not finite.
SteadyState find_steady_state(std::span<const double> samples);

}  // namespace arenite::fields
