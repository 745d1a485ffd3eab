#pragma once
#include <array>
#include <string>
#include <string_view>

#include "core/parameters.hpp"
#include "core/threads.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// One scheme for Newton's equations: a file beside this one, and its name in ARENITE_INTEGRATORS (parameters.hpp).
struct Integrator {
  Word word;
  /// Takes the forces at t_n in the sample to positions and seen velocities at t_{n+1}; walls and affine motion too. False if the contact list has
  /// become stale.
  bool (*sweep)(Sample&, const ThreadPool&);
  /// Finds starting values from a state whose velocities are those of its places; null where none are needed.
  void (*start)(Sample&);
  /// Between steps a predictor and corrector holds a predicted state, whose rates lack this share of the change of acceleration times dt/2, and its
  /// places this share of that times dt^2/2; 0 and 0 of other schemes.
  double velocity_share, position_share;
  /// Share of a step by which the places are ahead of the velocities that memories of friction are fed with.
  double lead;
  /// The stable step: p (omega dt)^2 + q lambda dt = 1 with damping lambda, and omega dt = undamped without.
  double p, q, undamped;
  /// Moves grains that are no disks, and boundaries that have a mass, too.
  bool moves_bodies;

  bool corrects() const { return velocity_share > 0; }
};

#define ARENITE_DECLARATION(name) extern const Integrator name;
ARENITE_INTEGRATORS(ARENITE_DECLARATION)
#undef ARENITE_DECLARATION

/// In the order of IntegratorKind.
#define ARENITE_ADDRESS(name) &name,
inline const std::array integrators{ARENITE_INTEGRATORS(ARENITE_ADDRESS)};
#undef ARENITE_ADDRESS
inline const Integrator& integrator_of(IntegratorKind kind) { return *integrators[static_cast<std::size_t>(kind)]; }
inline const Integrator& integrator_of(const Sample& s) { return integrator_of(s.integration.integrator); }

/// Those that move bodies, for sentences: a, b or c, each in `quotes`.
std::string integrators_of_bodies(std::string_view quotes = "\"");

/// A step of everything that is no disk or body and goes before them: walls, boundaries; `kick` and `ahead` as in SweepTask.
using MoveWalls = void (*)(Sample& sample, double kick, double ahead);

/// A step of all disks, in one sweep of the kernel, and of what goes with the cell. False if the contact list has become stale.
bool sweep_disks(Sample& sample, const ThreadPool& pool, Kernel::Sweep loop, MoveWalls move_walls, double kick = 0, double ahead = 0);

/// A step that kicks the integrated velocities on by the accelerations, and then drifts with them. They are then behind the places by `lag`, and the
/// velocities that forces see are `ahead` of them, s. False if the contact list has become stale.
bool kick_and_drift(Sample& sample, const ThreadPool& pool, double lag, double ahead);

// Where disks and walls are and how they move at one time. Integrators keep velocities half a step behind (Verlet) or a predicted state (Gear), which
// is brought to the time of the positions here.

/// What moves for itself, a disk that is a grain or a body, as it stands in the sample.
struct Mover {
  std::int32_t grain = 0;                  ///< the caller's index
  double mass = 1, inertia = 1, size = 1;  ///< kg, kg m^2, m
  Vec2 place;
  double angle = 0;
  Motion own, seen;  ///< as of Body
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
Motion motion_of(const Sample& sample, std::size_t k);

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
