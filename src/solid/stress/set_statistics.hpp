#pragma once
#include <string>
#include <vector>

#include "solid/stress/stress.hpp"
#include "statistics/histogram.hpp"

namespace arenite::stress {

/// What stresses are divided by: the sample's mean (or root mean square), Pa, and the same without each block.
struct Normaliser {
  bool over_mean = true;
  double value = 0;
  std::vector<double> without;  ///< one a block
};

/// Numbers of the stresses `sigma` of one set (Pa; they are scaled in place). Those over the set's own mean are left out where the sample's or the set's
/// own is near zero or the two differ in sign; then a note says so.
Numbers describe(const std::string& name, statistics::BlockedSample& sigma, const Normaliser& normaliser, std::vector<std::string>& notes);

/// Whether a mean is too near zero to divide by: below a tenth of the root mean square.
bool near_zero(double mean, double mean_square);

}  // namespace arenite::stress
