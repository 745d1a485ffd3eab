#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/threads.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Geometry and relative motion of a contact, in the conventions of model/packing.hpp; what is tangential is counted as
/// in PairPack.
template <int D> struct Kinematics {
  double overlap = 0;  ///< h; <= 0 where apart
  Vec<D> normal;       ///< from j (or the wall) to i
  Vec<D> branch;       ///< x_i - x_j; for a wall the vector from its plane to x_i
  double arm_i = 0, arm_j = 0;
  double approach = 0;   ///< dh/dt
  Turning<D> sliding{};  ///< v_s
  double curvature = 0;  ///< 1/R*

  /// The force of the laws on a grain that lies against something rigid, and its torque.
  SlotForce<D> force(const ContactForce<double, Turning<D>>& f) const {
    return {f.normal * normal + cross(f.tangential, normal), -arm_i * f.tangential, {}};
  }
};

/// What follows of the branch and the normal for a disk or sphere that lies against something rigid, seen at the
/// velocity `v` from there.
template <int D> inline void lean_on(Kinematics<D>& c, const GrainRecord<D>& a, double distance, Vec<D> v, Arms arms) {
  c.arm_i = arms == Arms::contact_point ? distance : a.radius;
  c.approach = -dot(v, c.normal);
  c.sliding = without_twist(cross(c.normal, v) - c.arm_i * a.omega, c.normal);
  c.curvature = 1.0 / a.radius;
}

/// Two disks or spheres. Where they are apart only the overlap is meant.
template <int D> inline Kinematics<D> pair_kinematics(const GrainRecord<D>& a, const GrainRecord<D>& b, Arms arms) {
  Kinematics<D> c;
  c.branch = a.place - b.place;
  const double distance = norm(c.branch);
  c.overlap = a.radius + b.radius - distance;
  if (!(c.overlap > 0)) return c;
  c.normal = (1.0 / distance) * c.branch;
  const double half = arms == Arms::contact_point ? 0.5 * c.overlap : 0.0;
  c.arm_i = a.radius - half;
  c.arm_j = b.radius - half;
  const Vec<D> v = a.velocity - b.velocity;
  c.approach = -dot(v, c.normal);
  c.sliding = without_twist(cross(c.normal, v) - c.arm_i * a.omega - c.arm_j * b.omega, c.normal);
  c.curvature = 1.0 / a.radius + 1.0 / b.radius;
  return c;
}

/// A disk or sphere and a wall, which moves at `velocity`; the contact point lies on the plane.
template <int D>
inline Kinematics<D> wall_kinematics(const GrainRecord<D>& a, const WallIn<D>& wall, Vec<D> velocity, int side,
                                     Arms arms) {
  Kinematics<D> c;
  c.normal = inward_normal<D>(side);
  const double distance = inward_sign(side) * (across(side, a.place) - wall.position);
  c.branch = distance * c.normal;
  c.overlap = a.radius - distance;
  if (!(c.overlap > 0)) return c;
  lean_on(c, a, distance, a.velocity - velocity, arms);
  return c;
}

/// What touches in a slot: disk i, or the foot of a polygon on a boundary's point.
template <int D> inline const GrainRecord<D>& touching_disk(const SampleIn<D>& s, std::size_t slot) {
  if (slot < s.list.polygons) return s.record[s.list.i[slot]];
  return s.record[s.count + s.ghost.size() + slot - s.list.polygons];
}

/// Of a slot whose partner is neither disk nor wall. Out of line: loops over walls go past it.
template <int D> [[gnu::noinline]] Kinematics<D> kinematics_at_part(const SampleIn<D>& s, std::size_t slot) {
  Kinematics<D> c;
  each_part(s, [&](const auto& part) { part.meet(s, slot, c); });
  return c;
}

template <int D> inline Kinematics<D> slot_kinematics(const SampleIn<D>& s, std::size_t slot) {
  const GrainRecord<D>& a = touching_disk(s, slot);
  const std::int32_t j = s.list.j[slot];
  if (j >= 0) return pair_kinematics(a, s.record[j], s.contact.arms);
  const int side = wall_side(j);
  if (side >= sides_in<D>) return kinematics_at_part(s, slot);
  const WallIn<D>& wall = s.domain.wall[side];
  return wall_kinematics(a, wall, of_side(side, wall.velocity, s.wall[side].drive.slide), side, s.contact.arms);
}

/// How the grains that touch in a slot turn together, rad/s.
template <int D> Turning<D> spin_of(const SampleIn<D>& s, std::size_t slot) {
  const Turning<D> spin = touching_disk(s, slot).omega;
  return s.list.j[slot] < 0 ? spin : spin + s.record[s.list.j[slot]].omega;
}

/// k_t of a slot that is met so, N/m.
template <class N, int D>
double sliding_stiffness(const SampleIn<D>& s, const N& normal, std::size_t slot, const Kinematics<D>& c) {
  return sliding_stiffness(s.laws, normal, std::max(c.overlap, 0.0), s.list.stiffness[slot], c.curvature,
                           s.list.shear[slot]);
}

/// Adds a force on a grain that a wall exerts to the wall's own, as its opposite.
template <int D> void push_wall(SampleIn<D>& s, int side, Vec<D> on_grain) {
  s.domain.wall[side].force += dot(on_grain, inward_normal<D>(side));
  s.domain.wall[side].shear_force -= along(side, on_grain);
}

}  // namespace arenite::dem
