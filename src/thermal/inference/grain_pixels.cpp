#include "thermal/inference/grain_pixels.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::inference {
namespace {

/// Shifts by whole cells that may bring a grain into the picture.
std::vector<Vec2> images(const Domain& domain) {
  std::vector<Vec2> shifts;
  const int nx = domain.periodic_x ? 1 : 0, ny = domain.periodic_y ? 1 : 0;
  for (int b = -ny; b <= ny; ++b)
    for (int a = -nx - (b ? nx : 0); a <= nx + (b ? nx : 0); ++a)
      shifts.push_back({a * domain.width() * nx + b * domain.tilt, b * domain.height() * ny});
  return shifts;
}

double to_contact(Vec2 x, double radius, const std::vector<Touch>& touches) {
  double nearest = 2 * radius;
  for (const Touch& t : touches) nearest = std::min(nearest, norm(x + radius * t.normal));
  return nearest;
}

}  // namespace

std::vector<std::vector<GrainPixel>> pixels_of_grains(const SwingPicture& picture, const Packing& packing,
                                                      const std::vector<std::vector<Touch>>& touches, double rim_margin, double contact_margin) {
  const double side = picture.pixel;
  std::vector<std::vector<GrainPixel>> pixels(packing.grains.size());
  const std::vector<Vec2> shifts = images(packing.domain);
  for (std::size_t g = 0; g < pixels.size(); ++g) {
    const double radius = packing.grains.radius[g], inner = radius - rim_margin * side;
    if (inner <= 0) continue;
    for (const Vec2 shift : shifts) {
      const Vec2 centre = packing.grains.centre(g) + shift;
      const double column = (centre.x - picture.first.x) / side, row = (picture.first.y - centre.y) / side, reach = inner / side;
      const int c0 = std::max(0, static_cast<int>(std::ceil(column - reach))), c1 = std::min(picture.width - 1, static_cast<int>(std::floor(column + reach)));
      const int r0 = std::max(0, static_cast<int>(std::ceil(row - reach))), r1 = std::min(picture.height - 1, static_cast<int>(std::floor(row + reach)));
      for (int r = r0; r <= r1; ++r)
        for (int c = c0; c <= c1; ++c) {
          const Vec2 x = Vec2{picture.first.x + c * side, picture.first.y - r * side} - centre;
          const std::size_t p = static_cast<std::size_t>(r) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(c);
          const float value = picture.value[p], error = picture.error[p];
          if (norm(x) > inner || !std::isfinite(value) || !std::isfinite(error) || !(error > 0)) continue;
          const double away = to_contact(x, radius, touches[g]);
          if (away >= 0.5 * contact_margin * side) pixels[g].push_back({x, value, error, away, p});
        }
    }
  }
  return pixels;
}

}  // namespace arenite::inference
