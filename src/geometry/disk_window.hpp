#pragma once
#include "core/vec2.hpp"
#include "geometry/rectangle.hpp"

namespace arenite::geometry {

/// Area that a disk and a rectangle have in common, exact to rounding.
double disk_window_area(Vec2 centre, double radius, const Rectangle& window);

}  // namespace arenite::geometry
