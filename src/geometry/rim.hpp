#pragma once
#include <vector>

#include "core/vec.hpp"
#include "geometry/outline.hpp"

namespace arenite::geometry {

/// Area, centroid and second moment of a region.
struct Moments {
  double area = 0;
  Vec2 centre;
  double polar = 0;  ///< integral of the squared distance from the centroid, m^4
};

/// The boundary of the union of disks: arcs with the inside on their left, loop after loop, each arc beginning where
/// the one before it ends. Holes are loops, too.
std::vector<Edge> rim_of_disks(const std::vector<Vec2>& centre, const std::vector<double>& radius);

/// The boundary of a convex polygon, corners counter-clockwise, widened by a radius: sides and arcs by turns.
std::vector<Edge> rim_of_polygon(const std::vector<Vec2>& corner, double radius);

/// Moments of the region within a rim, by Green's theorem; to rounding.
Moments moments_within(const std::vector<Edge>& rim);

}  // namespace arenite::geometry
