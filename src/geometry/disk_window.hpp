#pragma once
#include "core/vec2.hpp"

namespace arenite::geometry {

/// Axis-parallel rectangle, m.
struct Rectangle {
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;
  double width() const { return x_max - x_min; }
  double height() const { return y_max - y_min; }
  double area() const { return width() * height(); }
};

/// Area that a disk and a rectangle have in common, exact to rounding.
double disk_window_area(Vec2 centre, double radius, const Rectangle& window);

}  // namespace arenite::geometry
