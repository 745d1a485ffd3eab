#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "statistics/histogram.hpp"
#include "statistics/numbers.hpp"

namespace arenite::stress {

/// Sums of powers of d = x - shift.
struct Powers {
  double n = 0, d1 = 0, d2 = 0, d3 = 0, d4 = 0;

  Powers& operator+=(const Powers& b) { return n += b.n, d1 += b.d1, d2 += b.d2, d3 += b.d3, d4 += b.d4, *this; }
  Powers operator-(const Powers& b) const { return {n - b.n, d1 - b.d1, d2 - b.d2, d3 - b.d3, d4 - b.d4}; }
};

std::vector<Powers> powers_by_block(const statistics::BlockedSample& sample, double shift);

/// Sums of columns from clamp to clamp, of those of the blocks of which they are made. Errors of means come from them:
/// the force that is carried is the same in every row, so blocks of a column are no samples of their own.
template <class Sum> std::vector<Sum> by_column(const std::vector<Sum>& by_block, int columns) {
  std::vector<Sum> sums(static_cast<std::size_t>(columns));
  for (std::size_t b = 0; b < by_block.size(); ++b) sums[b % sums.size()] += by_block[b];
  return sums;
}

/// What stresses are divided by: the sample's mean (or root mean square), Pa, and the same without each block.
struct Normaliser {
  bool over_mean = true;
  double value = 0;
  std::vector<double> without;  ///< one a block
  int columns = 1;              ///< that the blocks stand in
};

/// Numbers of the stresses `sigma` of one set (Pa; they are scaled in place). Those over the set's own mean are left
/// out where the sample's or the set's own is near zero or the two differ in sign; then a note says so.
Numbers describe(const std::string& name, statistics::BlockedSample& sigma, const Normaliser& normaliser,
                 std::vector<std::string>& notes);

/// Whether a mean is too near zero to divide by: below a tenth of the root mean square.
inline bool near_zero(double mean, double mean_square) { return mean * mean <= 0.01 * mean_square; }

}  // namespace arenite::stress
