#include "geometry/ball_window.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/union_area.hpp"

namespace arenite::geometry {
namespace {

/// Of the part of a unit ball's height h that lies beyond a plane, for h from 0 to 2.
double cap(double h) { return std::numbers::pi * h * h * (1 - h / 3); }

}  // namespace

double ball_window_volume(Vec3 centre, double radius, const Box<3>& window) {
  const double whole = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  int cut = 0;
  double missing = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double inside :
         {centre[axis] - window.corner[axis], window.corner[axis] + window.size[axis] - centre[axis]}) {
      if (inside <= -radius) return 0;
      if (inside >= radius) continue;
      ++cut;
      missing += radius * radius * radius * cap(1 - inside / radius);
    }
  if (cut <= 1) return whole - missing;
  const double low = std::max(window.corner.z, centre.z - radius),
               high = std::min(window.corner.z + window.size.z, centre.z + radius);
  const Rectangle face{window.corner.x, window.corner.x + window.size.x, window.corner.y,
                       window.corner.y + window.size.y};
  const auto slice = [&](double z) {
    const double left = radius * radius - (z - centre.z) * (z - centre.z);
    return left > 0 ? disk_window_area({centre.x, centre.y}, std::sqrt(left), face) : 0.0;
  };
  constexpr int slices = 64;
  const double thickness = (high - low) / slices;
  double volume = 0;
  for (int k = 0; k < slices; ++k) volume += thickness * slice(low + (k + 0.5) * thickness);
  return volume;
}

}  // namespace arenite::geometry
