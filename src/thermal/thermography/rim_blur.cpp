#include "thermal/thermography/rim_blur.hpp"

#include <cmath>
#include <limits>

namespace arenite::thermography {
namespace {

/// Least mean distance between picture and drawing, by golden section; it has one minimum.
template <class Distance>
double nearest(double low, double high, const Distance& distance) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double a = high - golden * (high - low), b = low + golden * (high - low), at_a = distance(a), at_b = distance(b);
  while (high - low > 0.02) {
    if (at_a < at_b) {
      high = b, b = a, at_b = at_a;
      a = high - golden * (high - low), at_a = distance(a);
    } else {
      low = a, a = b, at_a = at_b;
      b = low + golden * (high - low), at_b = distance(b);
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

double rim_blur(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotion& motion, int threads) {
  if (grains.size() == 0 || pictures.size() == 0) return std::numeric_limits<double>::quiet_NaN();
  constexpr double least = 0.15, most = 1.6, middle = 0.6;
  constexpr float inside = 0.03f, outside = 0.97f;
  const PictureGrains there = grains_in(pictures, 0, grains, motion);
  const std::vector<float> seen = picture_of(pictures, 0);
  // Rims are where a lens of middling blur shows grain and background at once.
  const std::vector<float> open = draw_disks(there, std::vector<double>(grains.size(), 0.0), 1, middle, pictures.width, pictures.height);
  return nearest(least, most, [&](double blur) {
    const GrainScene scene = grain_scene(pictures, grains, motion, blur, threads);
    const std::vector<float> drawn = draw_disks(there, scene.grain, scene.background, blur, pictures.width, pictures.height);
    double sum = 0, count = 0;
    for (std::size_t p = 0; p < seen.size(); ++p)
      if (open[p] > inside && open[p] < outside) sum += std::abs(static_cast<double>(seen[p] - drawn[p])), ++count;
    return count > 0 ? sum / count : 0;
  });
}

}  // namespace arenite::thermography
