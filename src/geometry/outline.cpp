#include "geometry/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/circular_segment.hpp"

namespace arenite::geometry {
namespace {

Edge arc_edge(Vec2 centre, double radius, Vec2 a, Vec2 b) {
  Edge edge{a, b, centre, radius, std::atan2(a.y - centre.y, a.x - centre.x), 0};
  // From a to b the shorter way round; the arcs of this module all turn by less than half a circle.
  edge.sweep = std::atan2(cross(a - centre, b - centre), dot(a - centre, b - centre));
  return edge;
}

}  // namespace

bool contains(const Outline& o, Vec2 p) {
  const Vec2 d = p - o.centre;
  if (o.kind == Outline::Kind::disk) return dot(d, d) <= o.radius * o.radius;
  for (int k = 0; k < 4; ++k)
    if (cross(o.corner[(k + 1) & 3] - o.corner[k], p - o.corner[k]) < 0) return false;
  return o.kind == Outline::Kind::quadrilateral || dot(d, d) >= o.radius * o.radius;
}

Rectangle bounds(const Outline& o) {
  if (o.kind == Outline::Kind::disk)
    return {o.centre.x - o.radius, o.centre.x + o.radius, o.centre.y - o.radius, o.centre.y + o.radius};
  Rectangle box{o.corner[0].x, o.corner[0].x, o.corner[0].y, o.corner[0].y};
  for (const Vec2 c : o.corner)
    box = {std::min(box.x_min, c.x), std::max(box.x_max, c.x), std::min(box.y_min, c.y), std::max(box.y_max, c.y)};
  return box;
}

Vec2 Edge::at(double t) const {
  if (straight()) return a + t * (b - a);
  const double angle = from + t * sweep;
  return centre + radius * Vec2{std::cos(angle), std::sin(angle)};
}

Vec2 Edge::outward(double t) const {
  if (straight()) {
    const Vec2 d = b - a;
    return (1 / norm(d)) * Vec2{d.y, -d.x};
  }
  const double angle = from + t * sweep;
  return (sweep > 0 ? 1.0 : -1.0) * Vec2{std::cos(angle), std::sin(angle)};
}

double Edge::area_under(double t0, double t1) const {
  const double chord = 0.5 * cross(at(t0), at(t1));
  return straight() ? chord : chord + circular_segment_area(radius, sweep * (t1 - t0));
}

Edge straight_edge(Vec2 a, Vec2 b) { return {a, b, {}, 0, 0, 0}; }

Edges edges(const Outline& o) {
  if (o.kind == Outline::Kind::disk) {
    const Vec2 start = o.centre - Vec2{o.radius, 0};
    return {{Edge{start, start, o.centre, o.radius, -std::numbers::pi, 2 * std::numbers::pi}}, 1};
  }
  Edges all{{}, 4};
  for (int k = 0; k < 4; ++k) all.edge[k] = straight_edge(o.corner[k], o.corner[(k + 1) & 3]);
  if (o.kind == Outline::Kind::hollow) all.edge[2] = arc_edge(o.centre, o.radius, o.corner[2], o.corner[3]);
  return all;
}

Rectangle bounds(const Edge& e) {
  if (std::abs(e.sweep) > std::numbers::pi)
    return {e.centre.x - e.radius, e.centre.x + e.radius, e.centre.y - e.radius, e.centre.y + e.radius};
  Rectangle box{std::min(e.a.x, e.b.x), std::max(e.a.x, e.b.x), std::min(e.a.y, e.b.y), std::max(e.a.y, e.b.y)};
  if (e.straight()) return box;
  // An arc leaves the box of its ends by no more than its rise over the chord.
  const double rise = e.radius * (1 - std::cos(0.5 * e.sweep));
  return {box.x_min - rise, box.x_max + rise, box.y_min - rise, box.y_max + rise};
}

}  // namespace arenite::geometry
