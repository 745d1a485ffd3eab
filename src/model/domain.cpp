#include "model/domain.hpp"

#include <cmath>

namespace arenite {

Vec2 Domain::nearest_image(Vec2 d) const {
  if (periodic_y) {
    const double n = std::nearbyint(d.y / height());
    d.y -= n * height();
    d.x -= n * tilt;
  }
  if (periodic_x) d.x -= std::nearbyint(d.x / width()) * width();
  return d;
}

}  // namespace arenite
