#pragma once
#include "geometry/rectangle.hpp"

namespace arenite::geometry {

/// Volume of a ball inside an upright box, m^3: exact for one that lies within or is cut by one side, else to about
/// 1e-3 of the ball.
double ball_window_volume(Vec3 centre, double radius, const Box<3>& window);

}  // namespace arenite::geometry
