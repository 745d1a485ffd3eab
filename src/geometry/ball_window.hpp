#pragma once
#include "geometry/rectangle.hpp"
#include "geometry/union_area.hpp"

namespace arenite::geometry {

/// Volume of a ball inside an upright box, m^3, in closed form.
double ball_window_volume(Vec3 centre, double radius, const Box<3>& window);

/// What a disk or a ball covers of a window: area, volume.
inline double part_in(const Rectangle& window, Vec2 centre, double radius) {
  return disk_window_area(centre, radius, window);
}
inline double part_in(const Box<3>& window, Vec3 centre, double radius) {
  return ball_window_volume(centre, radius, window);
}

}  // namespace arenite::geometry
