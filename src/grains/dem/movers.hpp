#pragma once
#include <cstdint>

#include "grains/dem/integrators/time_step.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {

/// A step of the sample's integrator: takes the forces at t_n to places and seen velocities at t_{n+1}; walls,
/// boundaries, bodies and affine motion too. False if the contact list has become stale.
template <int D> bool make_step(SampleIn<D>& sample, const ThreadPool& pool);

// Where disks and walls are and how they move at one time. Integrators keep velocities half a step behind (Verlet) or a
// predicted state (Gear), which is brought to the time of the positions here.

/// What moves for itself, a disk that is a grain or a body, as it stands in the sample.
template <int D> struct Mover {
  std::int32_t grain = 0;                  ///< the caller's index
  double mass = 1, inertia = 1, size = 1;  ///< kg, kg m^2, m
  Vec<D> place;
  Turning<D> angle{};
  Motion<D> own, seen;  ///< as of Body
};
/// Of inner disk k, or, from `count` on, of a body.
template <int D> inline Mover<D> mover_at(const SampleIn<D>& s, std::size_t k) {
  if (k >= s.count) {
    Mover<D> body;
    each_part(s, [&](const auto& part) { part.put_mover(k - s.count, body); });
    return body;
  }
  const GrainRecord<D>& d = s.record[k];
  return {grain_of(s, d.grain), d.mass, inertia(d), d.radius, d.place, s.angle[k], {s.velocity[k], s.omega[k]},
          {d.velocity, d.omega}};
}
/// Calls `see` with their numbers: disks, then bodies.
template <int D, class See> void each_mover(const SampleIn<D>& s, const See& see) {
  for (std::size_t k = 0; k < s.count + body_count(s); ++k)
    if (k >= s.count || !is_part(s, k)) see(k);
}

/// Acceleration by contacts, gravity and drag, m/s^2, and that of the turning, rad/s^2.
template <int D> struct Acceleration {
  Vec<D> linear;
  Turning<D> alpha{};
};
/// On a mover by its contacts.
template <int D> Load<D> load_on(const SampleIn<D>& s, std::size_t mover) {
  if (mover < s.count) return contact_load(slot_forces(s.list), mover);
  Load<D> load;
  each_part(s, [&](const auto& part) { part.put_load(s, mover - s.count, load); });
  return load;
}
/// Of a mover; 0 of a disk that goes with a wall.
template <int D> Acceleration<D> acceleration_of(const SampleIn<D>& s, std::size_t k) {
  if (is_held(s, k)) return {};
  const Load<D> load = load_on(s, k);
  const Mover<D> m = mover_at(s, k);
  return {load.force / m.mass + s.gravity - s.drag * (m.seen.velocity - cell_motion(s.domain).at(m.place)),
          s.integration.rotations ? load.torque / m.inertia : Turning<D>{}};
}

/// What integrated rates and places lack, as so many times the acceleration that a scheme has not foreseen: s and s^2.
struct Behind {
  double rate = 0, place = 0;
};
template <int D> Behind behind(const SampleIn<D>& s) {
  const Integrator& scheme = integrator_of(s);
  if (!scheme.corrects()) return {s.lag, 0};
  if (!s.settled) return {};
  return {0.5 * scheme.velocity_share * s.dt, 0.5 * scheme.position_share * s.dt * s.dt};
}

template <int D> Acceleration<D> unforeseen(const SampleIn<D>& s, std::size_t k) {
  const Acceleration<D> a = acceleration_of(s, k);
  if (!integrator_of(s).corrects()) return a;
  return {a.linear - s.acceleration[k], a.alpha - s.alpha[k]};
}

template <int D> double unforeseen_of_wall(const SampleIn<D>& s, std::size_t side) {
  const double a = wall_acceleration(s, side, s.domain.wall[side].velocity);
  return integrator_of(s).corrects() ? a - s.wall[side].acceleration : a;
}

/// Motion of a mover, without the affine motion.
template <int D> Motion<D> motion_of(const SampleIn<D>& s, std::size_t k) {
  const Motion<D> own = mover_at(s, k).own;
  const double lag = behind(s).rate;
  if (lag == 0) return own;
  const Acceleration<D> a = unforeseen(s, k);
  return {own.velocity + lag * a.linear, own.omega + lag * a.alpha};
}

/// How long the integrated velocities are behind the forces, s: half a step, or nothing where a scheme has just begun.
template <int D> double time_behind(const SampleIn<D>& sample);
/// Integrated velocity of disk i beside disk j, or beside an image of j that moves past it so, m/s.
template <int D> Vec<D> velocity_beside(const SampleIn<D>& sample, std::size_t i, std::size_t j, Vec<D> image);

/// Place of a mover, m.
template <int D> Vec<D> place_of(const SampleIn<D>& s, std::size_t k) {
  const Vec<D> place = mover_at(s, k).place;
  const double lag = behind(s).place;
  return lag == 0 ? place : place + lag * unforeseen(s, k).linear;
}

/// Velocity of a wall (or edge of a periodic cell), m/s along its axis; the domain with the places and velocities of
/// its walls and boundaries.
template <int D> double wall_rate(const SampleIn<D>& s, std::size_t side) {
  return s.wall[side].rate + behind(s).rate * unforeseen_of_wall(s, side);
}

template <int D> DomainIn<D> domain_now(const SampleIn<D>& s) {
  DomainIn<D> domain = s.domain;
  for (int side = 0; side < sides_in<D>; ++side) {
    domain.wall[side].velocity = wall_rate(s, side);
    domain.wall[side].position += behind(s).place * unforeseen_of_wall(s, side);
  }
  each_part(s, [&](const auto& part) { part.bring_to_now(s, domain); });
  return domain;
}

}  // namespace arenite::dem
