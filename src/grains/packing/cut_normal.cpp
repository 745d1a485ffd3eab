#include "grains/packing/cut_normal.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::packing {

double CutNormal::draw(RandomStream& random, double below) const {
  const double top = std::min(high, below);
  if (top <= low) return low;
  if (deviation <= 0) return std::clamp(mean, low, top);
  // Rejection from the whole law is cheap where the range holds most of it, rejection from a rectangle where it is narrow.
  if (low <= mean && mean <= top && top - low > 2 * deviation) {
    for (;;)
      if (const double r = mean + deviation * random.normal(); r >= low && r <= top) return r;
  }
  const auto exponent = [&](double r) { return -0.5 * (r - mean) * (r - mean) / (deviation * deviation); };
  const double peak = exponent(std::clamp(mean, low, top));
  for (;;) {
    const double r = random.uniform(low, top);
    if (random.uniform() < std::exp(exponent(r) - peak)) return r;
  }
}

}  // namespace arenite::packing
