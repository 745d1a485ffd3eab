#pragma once
#include <optional>

#include "geometry/meniscus.hpp"

namespace arenite::geometry {

/// The half section of a bridge of revolution between two spheres, which are `disks` in the plane of their centres: on
/// its rim a circular arc, hollow outwards, that meets both spheres at the contact angle (the toroidal bridge of R. A.
/// Fisher, 1926). On sphere i it ends on a circle of `width` radii of that sphere; where that is wider than straight
/// surfaces allow, it is straight. Nothing where the arc would cut the joining line, where the end lies in sphere j,
/// and for a sphere inside the other. The contact angle is 0 to below pi/2, rad.
std::optional<MeniscusShape> round_bridge(const MeniscusDisks& disks, double contact_angle, double width);

}  // namespace arenite::geometry
