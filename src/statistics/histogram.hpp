#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "statistics/estimate.hpp"

namespace arenite::statistics {

/// Many values of a field, each in a block of the sample (all numbers below `blocks`).
struct BlockedSample {
  std::vector<double> x;
  std::vector<std::uint16_t> block;  ///< as long as x
  int blocks = 1;
};

/// Equal bins: bin k holds low + k width <= x < low + (k + 1) width.
struct Bins {
  double low = 0, width = 0;
  std::size_t count = 0;

  double edge(std::size_t k) const { return low + static_cast<double>(k) * width; }
  double centre(std::size_t k) const { return low + (static_cast<double>(k) + 0.5) * width; }
};

/// How many values lie below the first bin, in each bin, and above the last.
using Counts = std::vector<double>;
double total(const Counts& counts);

/// Counts of all values and of each block.
struct BlockCounts {
  Bins bins;
  Counts all;
  std::vector<Counts> block;

  Counts without(std::size_t b) const;
};

/// Extremes and quantiles of a sample: 0.01 %, 25 %, 75 %, 99.99 %.
struct Spread {
  double minimum = 0, low = 0, lower_quarter = 0, upper_quarter = 0, high = 0, maximum = 0;
};

/// Bins for a pdf. Their width is 1/N of low..high, or of 5.5 times lower..upper quarter (the same for a Gaussian)
/// where that is finer, but not below 1/1000 of low..high; N = 0.8 n^0.4, 10 to 200. They reach the extremes, but not
/// farther than twice low..high beyond. No bins where all values are equal.
Bins pdf_bins(std::size_t n, const Spread& spread);

BlockCounts count(const BlockedSample& sample, const Bins& bins);

/// Survival function at x: the share of the values above it, straight within a bin.
double survival(const Bins& bins, const Counts& counts, double x);

/// The inverse: the value below which a share p lies.
double quantile(const Bins& bins, const Counts& counts, double p);

/// Probability density in every bin; values outside the bins count in the total.
std::vector<double> density(const Bins& bins, const Counts& counts);

/// The density as a curve against the middles of the bins, with errors by leaving out one block at a time.
Curve pdf(const BlockCounts& counts);

/// Values at the shares p (rising) of all values, by rank: the value of index floor(p n).
std::vector<double> exact_quantiles(std::vector<double> values, const std::vector<double>& p);

/// A pdf in bins that are the same for every sample, so that samples may be averaged.
struct Histogram {
  Bins bins;
  std::vector<double> density;  ///< values outside of the bins count in the total
};

/// The density of factor * x in bins of 0.05 from -1 to 6.
Histogram histogram(const std::vector<double>& x, double factor);

/// Running means of three bins, of two at the ends.
std::vector<double> smoothed(const std::vector<double>& density);

/// Where a density is highest.
struct Peak {
  double at = unknown, height = unknown;
};

/// The highest running mean of three bins; unknown without bins.
Peak peak_of(const Bins& bins, const Counts& counts);

}  // namespace arenite::statistics
