#pragma once
#include <optional>

#include "core/vec.hpp"

namespace arenite::geometry {

/// Two disks and the arc of a liquid bridge with zero contact angle between them: a circle that touches both from
/// outside. Its curvature is 1/radius; 0 is the straight common tangent. Needs distance > |radius_i - radius_j|.
struct MeniscusDisks {
  double radius_i = 0, radius_j = 0, distance = 0;  ///< of centres, m
  double gap() const { return distance - radius_i - radius_j; }
};

/// Area of the liquid on both sides of the joining line (disks' overlap not counted), m^2.
double meniscus_area(const MeniscusDisks& disks, double curvature);

/// The largest curvature at which the arcs do not meet; infinite where the disks touch or overlap.
double largest_meniscus_curvature(const MeniscusDisks& disks);

/// The half above the joining line, in coordinates along it from centre i and away from it: the quadrilateral of both
/// centres and the points where the arc touches, less the arc's circle unless that is straight.
struct MeniscusShape {
  Vec2 touch_i, touch_j, centre;
  double radius = 0, length = 0;  ///< of the arc (0: straight), of the joining line, m
  bool contains(Vec2 p) const;    ///< p.y >= 0
};

/// Nothing where the arcs meet or one disk lies inside the other. `radius` may be infinite.
std::optional<MeniscusShape> meniscus_shape(const MeniscusDisks& disks, double radius);

}  // namespace arenite::geometry
