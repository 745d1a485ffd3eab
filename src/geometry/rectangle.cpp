#include "geometry/rectangle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arenite::geometry {
namespace {

double sector(Vec2 a, Vec2 b, double radius) { return 0.5 * radius * radius * std::atan2(cross(a, b), dot(a, b)); }

/// Signed area common to the disk about the origin and the triangle (origin, a, b).
double triangle_part(Vec2 a, Vec2 b, double radius) {
  const Vec2 d = b - a;
  const double length2 = dot(d, d);
  if (length2 == 0) return 0;
  const double middle = -dot(a, d) / length2;  // foot of the perpendicular, as share of a..b
  const double distance2 = std::pow(cross(a, d), 2) / length2;
  const double half2 = (radius * radius - distance2) / length2;
  if (half2 <= 0) return sector(a, b, radius);
  const double half = std::sqrt(half2);
  const double enter = std::clamp(middle - half, 0.0, 1.0), leave = std::clamp(middle + half, 0.0, 1.0);
  if (enter >= leave) return sector(a, b, radius);
  const Vec2 p = a + enter * d, q = a + leave * d;
  double area = 0.5 * cross(p, q);
  if (enter > 0) area += sector(a, p, radius);
  if (leave < 1) area += sector(q, b, radius);
  return area;
}

}  // namespace

double disk_window_area(Vec2 centre, double radius, const Rectangle& w) {
  const double x0 = w.x_min - centre.x, x1 = w.x_max - centre.x, y0 = w.y_min - centre.y, y1 = w.y_max - centre.y;
  if (x0 >= radius || x1 <= -radius || y0 >= radius || y1 <= -radius) return 0;
  if (x0 <= -radius && x1 >= radius && y0 <= -radius && y1 >= radius) return std::numbers::pi * radius * radius;
  const Vec2 corners[4] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  double area = 0;
  for (int k = 0; k < 4; ++k) area += triangle_part(corners[k], corners[(k + 1) % 4], radius);
  return std::clamp(area, 0.0, std::numbers::pi * radius * radius);
}

}  // namespace arenite::geometry
