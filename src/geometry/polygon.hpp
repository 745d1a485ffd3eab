#pragma once
#include <vector>

#include "core/vec.hpp"

namespace arenite::geometry {

/// A line that closes: its corners, in either sense.
using Polygon = std::vector<Vec2>;

double area_of(const Polygon& polygon);

/// Whether a point is inside; on the line either may be said.
bool encloses(const Polygon& polygon, Vec2 point);

/// The way from the nearest point of the line to another.
Vec2 way_from(const Polygon& polygon, Vec2 point);

}  // namespace arenite::geometry
