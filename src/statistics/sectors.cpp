#include "statistics/sectors.hpp"

#include <cmath>
#include <numbers>

namespace arenite::statistics {

std::vector<double> over_isotropic(std::vector<double> counts, double whole) {
  const double share = static_cast<double>(counts.size()) / whole;
  for (double& count : counts) count *= share;
  return counts;
}

std::vector<double> second_order_distribution(double anisotropy, double direction, int angles) {
  std::vector<double> values;
  for (int k = 0; k < angles; ++k)
    values.push_back(1 + anisotropy * std::cos(2 * (180.0 * k / angles - direction) * std::numbers::pi / 180));
  return values;
}

}  // namespace arenite::statistics
