#include "grains/dem/integrators/integrators.hpp"

#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

void move_walls(Sample& s, double kick, double ahead) {
  for (int side = 0; side < sides; ++side) {
    WallBody& body = s.wall[side];
    Wall& wall = s.domain.wall[side];
    body.acceleration = wall_acceleration(s, side, wall.velocity);
    body.rate += kick * body.acceleration;
    wall.position += s.dt * body.rate;
    wall.velocity = body.rate + ahead * body.acceleration;
  }
  push_boundaries(s, kick, ahead);
}

/// Velocity Verlet in its half-step form, one force evaluation and one sweep a step. Its growing mode flips sign every step.
///
/// The integrated velocity w belongs to the middle of the step: w_{n+1/2} = w_{n-1/2} + dt a_n, x_{n+1} = x_n + dt w_{n+1/2}, and v_n = w_{n-1/2} +
/// (dt/2) a_n. Forces depend on velocities, so they are given u_{n+1} = w_{n+1/2} + c (dt/2) a_n, where c is `extrapolation`: with 1
/// (velocity_verlet) that is v_{n+1} to second order; with 0 (leapfrog) it is the mid-step velocity, as LAMMPS's velocity Verlet has it: of first order
/// in the damping, stable up to twice the step.
template <int extrapolation> bool verlet(Sample& s, const ThreadPool& pool) { return kick_and_drift(s, pool, 0.5 * s.dt, extrapolation * 0.5 * s.dt); }

}  // namespace

bool kick_and_drift(Sample& s, const ThreadPool& pool, double lag, double ahead) {
  const double kick = s.dt - lag + s.lag;
  s.lag = lag;
  return sweep_disks(s, pool, s.kernel->verlet, move_walls, kick, ahead);
}

const Integrator velocity_verlet{{"velocity_verlet", "second order, the most robust"}, verlet<1>, nullptr, 0, 0, 0.5, 0.25, 1, 2, true};
const Integrator leapfrog{{"leapfrog", "second order, velocities half a step off"}, verlet<0>, nullptr, 0, 0, 1, 0.25, 0.5, 2, true};

}  // namespace arenite::dem
