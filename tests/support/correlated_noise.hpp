#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/random.hpp"
#include "model/film.hpp"

namespace arenite::test {

/// Noise as real cameras have it: of each pixel, and of all pixels together, correlated from frame to frame
/// (first-order autoregressive), each by the recursion itself from its stationary state on.
struct CorrelatedNoise {
  double own = 0.02, common = 0;  ///< standard deviations
  double correlation = 0;         ///< of one frame with the next
  std::uint64_t seed = 1;

  void add_to(Film& film) const {
    RandomStream random(seed, Purpose::test, 1234);
    const std::size_t pixels = film.about.pixels();
    std::vector<double> state(pixels + 1);
    for (double& s : state) s = random.normal();
    const double fresh = std::sqrt(1 - correlation * correlation);
    for (std::size_t n = 0; n * pixels < film.value.size(); ++n) {
      for (std::size_t p = 0; p < pixels; ++p)
        film.value[n * pixels + p] += static_cast<float>(own * state[p] + common * state[pixels]);
      for (double& s : state) s = correlation * s + fresh * random.normal();
    }
  }
};

}  // namespace arenite::test
