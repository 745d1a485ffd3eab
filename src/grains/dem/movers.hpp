#pragma once
#include "core/threads.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

inline const Integrator& integrator_of(const Sample& s) { return integrator_of(s.integration.integrator); }

/// A step of the sample's integrator: takes the forces at t_n to places and seen velocities at t_{n+1}; walls, boundaries, bodies and affine motion too.
/// False if the contact list has become stale.
bool make_step(Sample& sample, const ThreadPool& pool);

// Where disks and walls are and how they move at one time. Integrators keep velocities half a step behind (Verlet) or a predicted state (Gear), which
// is brought to the time of the positions here.

/// What moves for itself, a disk that is a grain or a body, as it stands in the sample.
struct Mover {
  std::int32_t grain = 0;                  ///< the caller's index
  double mass = 1, inertia = 1, size = 1;  ///< kg, kg m^2, m
  Vec2 place;
  double angle = 0;
  Motion<2> own, seen;  ///< as of Body
};
/// Of inner disk k, or, from `count` on, of a body.
inline Mover mover_at(const Sample& s, std::size_t k) {
  if (k >= s.count) {
    const Body& b = s.body[k - s.count];
    return {s.part[b.first].grain, b.mass, b.inertia(), b.gyration, b.place, b.angle, b.own, b.seen};
  }
  const DiskRecord& d = s.record[k];
  return {grain_of(s, d.grain), d.mass, inertia(d), d.radius, d.place, s.angle[k], {s.velocity[k], s.omega[k]}, {d.velocity, d.omega}};
}
/// Calls `see` with their numbers: disks, then bodies.
template <class See> void each_mover(const Sample& s, const See& see) {
  for (std::size_t k = 0; k < s.count + s.body.size(); ++k)
    if (k >= s.count || !is_part(s, k)) see(k);
}

/// Acceleration by contacts, gravity and drag, m/s^2, and that of the turning, rad/s^2.
struct Acceleration {
  Vec2 linear;
  double alpha = 0;
};
/// Of a mover; 0 of a disk that goes with a wall.
Acceleration acceleration_of(const Sample& sample, std::size_t k);

/// Motion of a mover, without the affine motion.
Motion<2> motion_of(const Sample& sample, std::size_t k);

/// How long the integrated velocities are behind the forces, s: half a step, or nothing where a scheme has just begun.
double time_behind(const Sample& sample);
/// Integrated velocity of disk i beside disk j, or beside an image of j that moves past it so, m/s.
Vec2 velocity_beside(const Sample& sample, std::size_t i, std::size_t j, Vec2 image);

/// Place of a mover, m.
Vec2 place_of(const Sample& sample, std::size_t k);

/// Velocity of a wall (or edge of a periodic cell), m/s along +x or +y; the domain with the places and velocities of its walls and boundaries.
double wall_rate(const Sample& sample, std::size_t side);
Domain domain_now(const Sample& sample);

}  // namespace arenite::dem
