#pragma once
#include "core/vec.hpp"

namespace arenite::geometry {

/// Axis-parallel rectangle, m.
struct Rectangle {
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;
  double width() const { return x_max - x_min; }
  double height() const { return y_max - y_min; }
  double area() const { return width() * height(); }
};

constexpr bool overlap(const Rectangle& a, const Rectangle& b) { return a.x_min <= b.x_max && b.x_min <= a.x_max && a.y_min <= b.y_max && b.y_min <= a.y_max; }

/// Area that a disk and a rectangle have in common, exact to rounding.
double disk_window_area(Vec2 centre, double radius, const Rectangle& window);

/// A box that holds disks: a rectangle from (x0, y0), m; a direction may be periodic.
struct Box {
  double x0 = 0, y0 = 0, width = 0, height = 0;
  bool periodic_x = false, periodic_y = false;
};

}  // namespace arenite::geometry
