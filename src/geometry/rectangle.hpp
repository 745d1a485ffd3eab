#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/vec.hpp"

namespace arenite::geometry {

/// Axis-parallel rectangle, m.
struct Rectangle {
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;
  double width() const { return x_max - x_min; }
  double height() const { return y_max - y_min; }
  double area() const { return width() * height(); }
  Vec2 middle() const { return {0.5 * (x_min + x_max), 0.5 * (y_min + y_max)}; }
  /// Counter-clockwise from the lower left one.
  std::array<Vec2, 4> corners() const { return {{{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}}}; }
  /// True inside and on the border.
  bool holds(Vec2 p) const { return p.x >= x_min && p.x <= x_max && p.y >= y_min && p.y <= y_max; }
};

constexpr Rectangle operator+(const Rectangle& r, Vec2 by) {
  return {r.x_min + by.x, r.x_max + by.x, r.y_min + by.y, r.y_max + by.y};
}

/// As far as `reach` from a place to every side.
constexpr Rectangle square_about(Vec2 place, double reach) {
  return {place.x - reach, place.x + reach, place.y - reach, place.y + reach};
}

/// The smallest upright rectangle around points, one at least.
inline Rectangle bounds(std::span<const Vec2> points) {
  Rectangle box{points[0].x, points[0].x, points[0].y, points[0].y};
  for (const Vec2 p : points)
    box = {std::min(box.x_min, p.x), std::max(box.x_max, p.x), std::min(box.y_min, p.y), std::max(box.y_max, p.y)};
  return box;
}

/// The same around disks; upside down if there is none.
inline Rectangle bounds(std::span<const Vec2> centres, std::span<const double> radii) {
  Rectangle box{INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const auto [x, y] = centres[i];
    const double r = radii[i];
    box = {std::min(box.x_min, x - r), std::max(box.x_max, x + r), std::min(box.y_min, y - r),
           std::max(box.y_max, y + r)};
  }
  return box;
}

/// The point of the segment from a to b that is nearest to a place. In line, as a step of polygons is half of this.
template <int D> [[gnu::always_inline]] inline Vec<D> nearest_on_segment(Vec<D> a, Vec<D> b, Vec<D> place) {
  const Vec<D> along = b - a;
  return a + std::clamp(dot(place - a, along) / dot(along, along), 0.0, 1.0) * along;
}

constexpr bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.x_min <= b.x_max && b.x_min <= a.x_max && a.y_min <= b.y_max && b.y_min <= a.y_max;
}

/// What holds disks (D = 2) or spheres (3): from its lowest corner, m; a direction may be periodic.
template <int D> struct Box {
  Vec<D> corner, size;
  std::array<bool, D> periodic{};

  Vec<D> end() const { return corner + size; }
  /// Of a vector between two points.
  Vec<D> nearest_image(Vec<D> d) const {
    for (int axis = 0; axis < D; ++axis)
      if (periodic[axis]) d[axis] -= size[axis] * std::nearbyint(d[axis] / size[axis]);
    return d;
  }
};

}  // namespace arenite::geometry
