#include "grains/texture/oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arenite::texture {
namespace {

/// Standard deviation of the length of (a, 0) and normal noise of deviation 1 in both parts (S. O. Rice, Bell Syst.
/// Tech. J. 24, 46, 1945).
double rice_deviation(double a) {
  if (a > 5) return 1;
  const double half = a * a / 4,
               mean = std::sqrt(std::numbers::pi / 2) * std::exp(-half) *
                      ((1 + 2 * half) * std::cyl_bessel_i(0, half) + 2 * half * std::cyl_bessel_i(1, half));
  return std::sqrt(std::max(0.0, 2 + a * a - mean * mean));
}

}  // namespace

Oscillation oscillation(const Estimate& x, const Estimate& y, int m) {
  constexpr double degrees = 180 / std::numbers::pi, random = std::numbers::pi / std::numbers::sqrt3;
  const double amplitude = std::hypot(x.value, y.value), angle = std::atan2(y.value, x.value) / m * degrees;
  const double noise2 = 0.5 * (x.error * x.error + y.error * y.error), noise = std::sqrt(noise2);
  Oscillation found{{amplitude}, {angle < 0 ? angle + 360.0 / m : angle}};
  if (noise == 0) found.amplitude.error = found.direction_deg.error = 0;
  if (!(noise > 0)) return found;
  const double truth = std::sqrt(std::max(0.0, amplitude * amplitude - 2 * noise2));
  const double along = std::hypot(x.value * x.error, y.value * y.error) / amplitude;
  found.amplitude.error = truth > 0 ? along * rice_deviation(truth / noise) : noise * rice_deviation(0);
  // Order of four and six folds reaches beyond a block of a dozen grains, so that blocks show too little noise.
  const double shared = m > 2 ? 1.25 * noise : noise,
               sure = std::sqrt(std::max(0.0, amplitude * amplitude - shared * shared));
  found.direction_deg.error = (sure > 0 ? std::min(shared / sure, random) : random) / m * degrees;
  return found;
}

}  // namespace arenite::texture
