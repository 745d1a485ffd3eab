#pragma once
#include <vector>

#include "statistics/blocked_sample.hpp"

namespace arenite::statistics {

/// A pdf in bins that are the same for every sample, so that samples may be averaged.
struct EvenDensity {
  Bins bins;
  std::vector<double> density;           ///< values outside of the bins count in the total
};

/// The density of factor * x in bins of 0.05 from -1 to 6.
EvenDensity even_density(const std::vector<double>& x, double factor);

/// Running means of three bins, of two at the ends.
std::vector<double> smoothed(const std::vector<double>& density);

/// Where a density is highest.
struct Peak {
  double at = unknown, height = unknown;
};

/// The highest running mean of three bins; unknown without bins.
Peak peak_of(const Bins& bins, const Counts& counts);

}  // namespace arenite::statistics
