#include "grains/texture/rev.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/estimate.hpp"

namespace arenite::texture {

Rev growing_windows(const RevWindows& windows, int dimension, std::uint64_t seed, double error_of_sample,
                    const WindowFractions& fractions) {
  const int places = windows.places;
  Rev r;
  for (int s = 0; s < windows.sizes; ++s) {
    const double side = 0.05 + (0.98 - 0.05) * (windows.sizes > 1 ? static_cast<double>(s) / (windows.sizes - 1) : 1);
    double sum = 0, squares = 0, share = 1;
    for (const double fraction :
         fractions(side, places, RandomStream(seed, Purpose::window, static_cast<std::uint64_t>(s)))) {
      sum += fraction;
      squares += fraction * fraction;
    }
    const double mean = sum / places;
    const double deviation =
        places > 1 ? std::sqrt(std::max(0.0, (squares - places * mean * mean) / (places - 1))) : statistics::unknown;
    for (int axis = 0; axis < dimension; ++axis) share *= side;
    r.share.push_back(share);
    r.mean.push_back(mean);
    r.deviation.push_back(deviation);
    r.error.push_back(std::hypot(deviation / std::sqrt(static_cast<double>(places)), error_of_sample));
  }
  return r;
}

Numbers numbers_of(const Rev& rev, const char* share) {
  return {{share, rev.share}, {"mean", rev.mean}, {"deviation", rev.deviation}, {"error", rev.error}};
}

}  // namespace arenite::texture
