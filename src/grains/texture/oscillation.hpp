#pragma once
#include "statistics/estimate.hpp"

namespace arenite::texture {

using statistics::Estimate;

/// How strongly and which way something depends on direction, A cos m(theta - theta_0).
struct Oscillation {
  Estimate amplitude, direction_deg;  ///< the direction in [0, 360/m)
};

/// By its parts along cos m theta and sin m theta. Noise of the same size in both, sigma, makes an amplitude out of
/// nothing: a true one a, found as A, is about sqrt(A^2 - 2 sigma^2), the scatter of A is that of Rice's distribution
/// (0.655 sigma where there is nothing, sigma where a is large). A direction is known to sigma/(m sqrt(A^2 - sigma^2)),
/// with 1.25 sigma for m > 2, but never worse than a random one, (360/m)/sqrt(12): in root mean square over samples
/// that is 0.8 to 1.4 times what directions scatter by, for any a.
Oscillation oscillation(const Estimate& x, const Estimate& y, int m);

}  // namespace arenite::texture
