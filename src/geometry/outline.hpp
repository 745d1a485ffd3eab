#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/vec.hpp"
#include "geometry/rectangle.hpp"

namespace arenite::geometry {

/// Area between an arc that turns by `angle` (rad, its sign is the area's) and its chord, radius^2 (angle - sin
/// angle)/2, without loss of digits where the arc is nearly straight.
double circular_segment_area(double radius, double angle);

/// A shape bounded by straight lines and arcs: a disk; a convex quadrilateral; or one that a circle has hollowed along
/// the edge from corner 2 to corner 3, whose ends lie on that circle.
struct Outline {
  enum class Kind { disk, quadrilateral, hollow };
  Kind kind = Kind::disk;
  std::array<Vec2, 4> corner{};  ///< counter-clockwise (quadrilateral, hollow)
  Vec2 centre;                   ///< of the circle (disk, hollow)
  double radius = 0;             ///< of the circle

  static Outline disk(Vec2 centre, double radius) { return {Kind::disk, {}, centre, radius}; }
};

/// True inside and on the boundary.
bool contains(const Outline& outline, Vec2 point);

/// The smallest upright rectangle around it.
Rectangle bounds(const Outline& outline);

/// A piece of a boundary, from `a` to `b` with the inside on its left; an arc turns by `sweep` about `centre`
/// (positive: counter-clockwise), a line has radius 0.
struct Edge {
  Vec2 a, b, centre;
  double radius = 0, from = 0, sweep = 0;
  bool straight() const { return radius == 0; }
  Vec2 at(double t) const;       ///< t from 0 to 1
  Vec2 outward(double t) const;  ///< unit normal there, to the outside
  /// Integral of (x dy - y dx)/2 along the part from t0 to t1 (Green): summed round a shape it gives the area.
  double area_under(double t0, double t1) const;
};

struct Edges {
  std::array<Edge, 4> edge;
  int count = 0;
  const Edge* begin() const { return edge.data(); }
  const Edge* end() const { return edge.data() + count; }
};

Edges edges(const Outline& outline);
Edge straight_edge(Vec2 a, Vec2 b);
Rectangle bounds(const Edge& edge);

/// A part of an edge, t from 0 to 1.
struct Part {
  double from, to;
};

/// Sorts parts and joins those that touch.
void merge(std::vector<Part>& parts);

/// Calls see(from, to) for what the parts leave of an edge, one after the other; sorts and joins the parts.
template <class See> void each_rest(std::vector<Part>& parts, See&& see) {
  merge(parts);
  double from = 0;
  for (const Part& part : parts) {
    if (part.from > from) see(from, part.from);
    from = part.to;
  }
  if (from < 1) see(from, 1.0);
}

/// Which side of an edge an outline has to cover for the edge to be no boundary of the union. Beside its own shape's
/// (outside) this settles edges of two shapes that coincide: `either` gives the edge to the other shape.
enum class CoveredSide { outside, either, inside };

/// Appends the parts of `edge` along which `outline` covers that side. Sides are looked at `step` (m) off the edge, far
/// less than the shapes' size and far more than rounding.
void add_covered_parts(const Edge& edge, const Outline& outline, CoveredSide side, double step,
                       std::vector<Part>& parts);

/// Appends the parts of `edge` that do not lie inside the window (on its border counts as not inside).
void add_parts_outside(const Edge& edge, const Rectangle& window, double step, std::vector<Part>& parts);

}  // namespace arenite::geometry
