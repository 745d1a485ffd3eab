#pragma once
#include "grains/dem/forces.hpp"

namespace arenite::dem {

// Where disks and walls are and how they move at one time. Integrators keep velocities half a step behind (Verlet) or a predicted state (Gear), which
// is brought to the time of the positions here.

/// Acceleration by contacts, gravity and drag, m/s^2, and that of the turning, rad/s^2.
struct Acceleration {
  Vec2 linear;
  double alpha = 0;
};
/// Of a mover (sample.hpp); 0 of a disk that goes with a wall.
Acceleration acceleration_of(const Sample& sample, std::size_t k);

/// Motion of a mover, without the affine motion.
Motion motion_of(const Sample& sample, std::size_t k);

/// How long the integrated velocities are behind the forces, s: half a step, or nothing where a scheme has just begun.
double time_behind(const Sample& sample);
/// Integrated velocity of disk i beside disk j, or beside an image of j that moves past it so, m/s.
Vec2 velocity_beside(const Sample& sample, std::size_t i, std::size_t j, Vec2 image);

/// Place of a mover, m.
Vec2 place_of(const Sample& sample, std::size_t k);

/// Velocity and position of a wall (or edge of a periodic cell), m/s and m along +x or +y.
double wall_rate(const Sample& sample, std::size_t side);
double wall_place(const Sample& sample, std::size_t side);

}  // namespace arenite::dem
