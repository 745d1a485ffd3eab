#pragma once
#include "core/random.hpp"

namespace arenite::packing {

/// Normal law of radii that keeps only those in [low, high], m.
struct CutNormal {
  double mean = 0, deviation = 0, low = 0, high = 0;

  /// One radius of the law; with `below` one of its part in [low, below].
  double draw(RandomStream& random) const { return draw(random, high); }
  double draw(RandomStream& random, double below) const;
};

}  // namespace arenite::packing
