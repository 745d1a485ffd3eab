#include "geometry/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace arenite::geometry {

namespace {

Edge arc_edge(Vec2 centre, double radius, Vec2 a, Vec2 b) {
  Edge edge{a, b, centre, radius, std::atan2(a.y - centre.y, a.x - centre.x), 0};
  // From a to b the shorter way round; the arcs of this module all turn by less than half a circle.
  edge.sweep = std::atan2(cross(a - centre, b - centre), dot(a - centre, b - centre));
  return edge;
}

/// Where an edge may change sides: parameters in (0, 1) between two ends. At most two for each of five curves.
struct Cuts {
  double at[16] = {0};
  int count = 1;
  void add(double t) {
    if (t > 0 && t < 1) at[count++] = t;
  }
  void close() {
    std::sort(at, at + count);
    at[count++] = 1;
  }
};

void add_point(const Edge& edge, Vec2 p, Cuts& cuts) {
  if (edge.straight()) {
    const Vec2 d = edge.b - edge.a;
    return cuts.add(dot(p - edge.a, d) / dot(d, d));
  }
  const double angle = std::atan2(p.y - edge.centre.y, p.x - edge.centre.x);
  double turn = edge.sweep > 0 ? angle - edge.from : edge.from - angle;
  turn -= 2 * std::numbers::pi * std::floor(turn / (2 * std::numbers::pi));
  cuts.add(turn / std::abs(edge.sweep));
}

struct Points {
  Vec2 at[2];
  int count = 0;
};

/// Curves that all but touch are cut where they come closest, so that no part's middle lies there.
constexpr double nearly = 1e-6;

/// Whichever of two curves is cut by the other, these are the same points to the last bit; else near a tangent the two
/// boundaries would not close.
Points on_line_and_circle(Vec2 p, Vec2 q, Vec2 centre, double radius) {
  const Vec2 d = q - p;
  const double length2 = dot(d, d);
  if (length2 == 0) return {};
  const Vec2 foot = p + (dot(centre - p, d) / length2) * d, off = foot - centre;
  const double half2 = radius * radius - dot(off, off);
  if (half2 <= 0) return {{foot, {}}, half2 > -nearly * radius * radius ? 1 : 0};
  const Vec2 half = std::sqrt(half2 / length2) * d;
  return {{foot - half, foot + half}, 2};
}

Points on_two_circles(Vec2 a, double ra, Vec2 b, double rb) {
  if (std::tie(b.x, b.y, rb) < std::tie(a.x, a.y, ra)) std::swap(a, b), std::swap(ra, rb);
  const Vec2 d = b - a;
  const double distance = norm(d);
  if (distance == 0) return {};
  const double outside = distance - (ra + rb), inside = std::abs(ra - rb) - distance;
  if (outside >= 0 || inside >= 0) {
    if (std::max(outside, inside) > nearly * std::min(ra, rb)) return {};
    const double sign = outside >= 0 || ra > rb ? 1 : -1;
    return {{a + (sign * ra / distance) * d, {}}, 1};
  }
  const double along = 0.5 * ((ra - rb) * (ra + rb) / distance + distance);
  const Vec2 foot = a + (along / distance) * d;
  const Vec2 half = (std::sqrt(std::max(0.0, (ra - along) * (ra + along))) / distance) * perpendicular(d);
  return {{foot - half, foot + half}, 2};
}

void cut_by_circle(const Edge& edge, Vec2 centre, double radius, Cuts& cuts) {
  const Points points = edge.straight() ? on_line_and_circle(edge.a, edge.b, centre, radius)
                                        : on_two_circles(edge.centre, edge.radius, centre, radius);
  for (int k = 0; k < points.count; ++k) add_point(edge, points.at[k], cuts);
}

void cut_by_line(const Edge& edge, Vec2 p, Vec2 q, Cuts& cuts) {
  if (edge.straight()) {
    const double slope = cross(edge.b - edge.a, q - p);
    if (slope != 0) cuts.add(cross(p - edge.a, q - p) / slope);
    return;
  }
  const Points points = on_line_and_circle(p, q, edge.centre, edge.radius);
  for (int k = 0; k < points.count; ++k) add_point(edge, points.at[k], cuts);
}

template <class IsCovered>
void add_where(const Edge& edge, Cuts& cuts, IsCovered&& is_covered, std::vector<Part>& parts) {
  cuts.close();
  for (int k = 0; k + 1 < cuts.count; ++k) {
    const double t0 = cuts.at[k], t1 = cuts.at[k + 1];
    if (t1 <= t0) continue;
    const double middle = 0.5 * (t0 + t1);
    if (is_covered(edge.at(middle), edge.outward(middle))) parts.push_back({t0, t1});
  }
}

}  // namespace

double circular_segment_area(double radius, double angle) {
  const double square = angle * angle;
  const double series =
      angle * square / 6 *
      (1 - square / 20 * (1 - square / 42 * (1 - square / 72 * (1 - square / 110 * (1 - square / 156)))));
  const double difference = std::abs(angle) > 0.3 ? angle - std::sin(angle) : series;
  return 0.5 * radius * radius * difference;
}

bool contains(const Outline& o, Vec2 p) {
  const Vec2 d = p - o.centre;
  if (o.kind == Outline::Kind::disk) return dot(d, d) <= o.radius * o.radius;
  for (int k = 0; k < 4; ++k)
    if (cross(o.corner[(k + 1) & 3] - o.corner[k], p - o.corner[k]) < 0) return false;
  return o.kind == Outline::Kind::quadrilateral || dot(d, d) >= o.radius * o.radius;
}

Rectangle bounds(const Outline& o) {
  return o.kind == Outline::Kind::disk ? square_about(o.centre, o.radius) : bounds(o.corner);
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
  if (std::abs(e.sweep) > std::numbers::pi) return square_about(e.centre, e.radius);
  Rectangle box{std::min(e.a.x, e.b.x), std::max(e.a.x, e.b.x), std::min(e.a.y, e.b.y), std::max(e.a.y, e.b.y)};
  if (e.straight()) return box;
  // An arc leaves the box of its ends by no more than its rise over the chord.
  const double rise = e.radius * (1 - std::cos(0.5 * e.sweep));
  return {box.x_min - rise, box.x_max + rise, box.y_min - rise, box.y_max + rise};
}

void merge(std::vector<Part>& parts) {
  std::sort(parts.begin(), parts.end(), [](Part a, Part b) { return a.from < b.from; });
  std::size_t last = 0;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    if (parts[k].from <= parts[last].to) parts[last].to = std::max(parts[last].to, parts[k].to);
    else parts[++last] = parts[k];
  }
  if (!parts.empty()) parts.resize(last + 1);
}

void add_covered_parts(const Edge& edge, const Outline& outline, CoveredSide side, double step,
                       std::vector<Part>& parts) {
  Cuts cuts;
  if (outline.kind != Outline::Kind::quadrilateral) cut_by_circle(edge, outline.centre, outline.radius, cuts);
  if (outline.kind != Outline::Kind::disk)
    for (int k = 0; k < 4; ++k) cut_by_line(edge, outline.corner[k], outline.corner[(k + 1) & 3], cuts);
  add_where(
      edge, cuts,
      [&](Vec2 p, Vec2 outward) {
        return (side != CoveredSide::inside && contains(outline, p + step * outward)) ||
               (side != CoveredSide::outside && contains(outline, p - step * outward));
      },
      parts);
}

void add_parts_outside(const Edge& edge, const Rectangle& w, double step, std::vector<Part>& parts) {
  Cuts cuts;
  const auto corner = w.corners();
  for (std::size_t k = 0; k < 4; ++k) cut_by_line(edge, corner[k], corner[(k + 1) & 3], cuts);
  const auto inside = [&](Vec2 p) { return p.x > w.x_min && p.x < w.x_max && p.y > w.y_min && p.y < w.y_max; };
  add_where(
      edge, cuts, [&](Vec2 p, Vec2 outward) { return !inside(p + step * outward) || !inside(p - step * outward); },
      parts);
}

}  // namespace arenite::geometry
