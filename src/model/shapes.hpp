#pragma once
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "geometry/outline.hpp"
#include "model/packing.hpp"

namespace arenite {

/// A rigid grain by its disks: their union, or, filled, the convex polygon of their centres (counter-clockwise) widened
/// by their common radius.
struct Shape {
  std::vector<Vec2> place;     ///< m
  std::vector<double> radius;  ///< m
  bool filled = false;
};

/// The boundary of a shape.
std::vector<geometry::Edge> rim_of(const Shape& shape);

/// A shape moved to its centre of mass and scaled so that it has the area of a disk of that radius, m.
Shape scaled_to(const Shape& shape, double radius);

/// Radius of gyration about the origin, m, and of the circle about the origin that holds the shape, m.
double gyration_of(const Shape& shape);
double reach_of(const Shape& shape);

/// The shape of a grain about its centre where its angle is 0; a disk's is itself.
Shape shape_of(const Grains& grains, std::size_t grain);

/// Appends the next grain's shape, about its centre of mass.
void add_shape(Shapes& shapes, const Shape& shape, double gyration);

/// Points along a grain's rim as it lies, m, loop closed; arcs in steps of `step` rad at most.
std::vector<Vec2> outline_of(const Grains& grains, std::size_t grain, double step = 0.2);

/// Unit vector at an angle from x, the same bits on every machine: sums and products alone.
Vec2 direction(double angle);
/// A vector turned by the angle of a direction.
constexpr Vec2 turned(Vec2 v, Vec2 by) { return {by.x * v.x - by.y * v.y, by.y * v.x + by.x * v.y}; }

/// Angles, rad, counter-clockwise from x.
struct Turn {
  double from = 0, by = 0;
};
/// So many points on a circle, `steps` of them in a turn, in decimals as one would write them (core/decimals.hpp).
std::vector<Vec2> points_on_arc(Vec2 centre, double diameter, const Turn& turn, std::int64_t steps, std::int64_t count);

}  // namespace arenite
