#include "ledger/final_texture.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::ledger {

double chance_of_one_law(std::vector<double> a, std::vector<double> b) {
  if (a.empty() || b.empty()) return statistics::unknown;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  const auto n = static_cast<double>(a.size()), m = static_cast<double>(b.size());
  double distance = 0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double x = std::min(a[i], b[j]);
    while (i < a.size() && a[i] == x) ++i;
    while (j < b.size() && b[j] == x) ++j;
    distance = std::max(distance, std::abs(static_cast<double>(i) / n - static_cast<double>(j) / m));
  }
  // Kolmogorov's series with Stephens's correction for finite samples.
  const double root = std::sqrt(n * m / (n + m)), t = (root + 0.12 + 0.11 / root) * distance;
  if (t < 0.2) return 1;
  double sum = 0;
  for (int k = 1; k <= 100; ++k) sum += (k % 2 == 1 ? 2 : -2) * std::exp(-2.0 * k * k * t * t);
  return std::clamp(sum, 0.0, 1.0);
}

}  // namespace arenite::ledger
