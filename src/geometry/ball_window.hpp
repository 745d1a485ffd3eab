#pragma once
#include "geometry/rectangle.hpp"

namespace arenite::geometry {

/// Volume of a ball inside an upright box, m^3, in closed form.
double ball_window_volume(Vec3 centre, double radius, const Box<3>& window);

}  // namespace arenite::geometry
