#pragma once

namespace arenite::geometry {

/// Axis-parallel rectangle, m.
struct Rectangle {
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;
  double width() const { return x_max - x_min; }
  double height() const { return y_max - y_min; }
  double area() const { return width() * height(); }
};

constexpr bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.x_min <= b.x_max && b.x_min <= a.x_max && a.y_min <= b.y_max && b.y_min <= a.y_max;
}

}  // namespace arenite::geometry
