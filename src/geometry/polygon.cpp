#include "geometry/polygon.hpp"

#include <cmath>
#include <limits>

#include "geometry/rectangle.hpp"

namespace arenite::geometry {
namespace {

template <class Visit> void each_segment(const Polygon& polygon, const Visit& visit) {
  for (std::size_t k = 0; k < polygon.size(); ++k) visit(polygon[k], polygon[(k + 1) % polygon.size()]);
}

}  // namespace

double area_of(const Polygon& polygon) {
  double twice = 0;
  each_segment(polygon, [&](Vec2 a, Vec2 b) { twice += cross(a, b); });
  return 0.5 * std::abs(twice);
}

bool encloses(const Polygon& polygon, Vec2 point) {
  bool inside = false;
  each_segment(polygon, [&](Vec2 a, Vec2 b) {
    const bool crosses = (a.y > point.y) != (b.y > point.y);
    if (crosses && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)) inside = !inside;
  });
  return inside;
}

Vec2 way_from(const Polygon& polygon, Vec2 point) {
  Vec2 nearest{};
  double least = std::numeric_limits<double>::infinity();
  each_segment(polygon, [&](Vec2 a, Vec2 b) {
    const Vec2 way = point - nearest_on_segment(a, b, point);
    if (norm(way) < least) least = norm(way), nearest = way;
  });
  return nearest;
}

}  // namespace arenite::geometry
