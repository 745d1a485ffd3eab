#include "thermal/inference/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arenite::inference {
namespace {

/// One axis of a box of side 1 blurred by a Gaussian, and its derivative.
struct Profile {
  double value, slope;
};

Profile profile(double u, double blur) {
  if (blur <= 0) return {std::abs(u) < 0.5 ? 1.0 : 0.0, 0.0};
  const double scale = 1 / (std::numbers::sqrt2 * blur), a = (u + 0.5) * scale, b = (u - 0.5) * scale;
  return {0.5 * (std::erf(a) - std::erf(b)), scale / std::sqrt(std::numbers::pi) * (std::exp(-a * a) - std::exp(-b * b))};
}

}  // namespace

Footprint::Footprint(double pixel, double blur) {
  constexpr double step = 0.25, least = 2e-4;  // least: share of the largest weight
  const int n = static_cast<int>(std::ceil((0.5 + 3 * blur) / step));
  double sum = 0;
  for (int r = -n; r < n; ++r)
    for (int c = -n; c < n; ++c) {
      const Vec2 place{(c + 0.5) * step, (r + 0.5) * step};
      const Profile x = profile(place.x, blur), y = profile(place.y, blur);
      if (x.value * y.value < least) continue;
      points.push_back({pixel * place, x.value * y.value, (1 / pixel) * Vec2{x.slope * y.value, x.value * y.slope}});
      sum += x.value * y.value;
      reach = std::max(reach, pixel * norm(place));
    }
  for (Point& p : points) p.weight /= sum, p.slope = (1 / sum) * p.slope;
}

}  // namespace arenite::inference
