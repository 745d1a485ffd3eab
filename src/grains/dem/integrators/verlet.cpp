#include "grains/dem/integrators/verlet.hpp"

#include "grains/dem/integrators/disk_sweep.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {

namespace {

void move_walls(Sample& s, double kick, double ahead) {
  for (std::size_t side = 0; side < 4; ++side) {
    WallBody& body = s.wall[side];
    Wall& wall = s.domain.wall[side];
    body.acceleration = wall_acceleration(s, side, wall.velocity);
    body.rate += kick * body.acceleration;
    wall.position += s.dt * body.rate;
    wall.velocity = body.rate + ahead * body.acceleration;
  }
}

}  // namespace

bool verlet_sweep(Sample& s, double extrapolation, const Team& team) {
  const double kick = s.lag + 0.5 * s.dt, ahead = extrapolation * 0.5 * s.dt;
  DiskSweep sweep(s);
  sweep.task.kick = kick;
  sweep.task.ahead = ahead;
  move_walls(s, kick, ahead);
  s.lag = 0.5 * s.dt;
  return sweep.run(s.kernel->verlet, team);
}

}  // namespace arenite::dem
