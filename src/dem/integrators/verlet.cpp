#include "dem/integrators/verlet.hpp"

#include "dem/forces.hpp"
#include "dem/walls.hpp"

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

void verlet_sweep(Sample& s, double extrapolation) {
  const double dt = s.dt, kick = s.lag + 0.5 * dt, ahead = extrapolation * 0.5 * dt;
  const AffineMotion mx = affine_x(s.domain), my = affine_y(s.domain);
  const CellFrame before = cell_frame(s.domain);
  const double turning = s.integration.rotations ? 1.0 : 0.0;
  for (std::size_t k = 0; k < s.count; ++k) {
    const Load load = contact_load(s.list, k);
    const DiskRecord& d = s.record[k];
    const double inverse_mass = 1.0 / d.mass;
    s.ax[k] = load.fx * inverse_mass + s.gravity.x - s.drag * (d.vx - mx.at(d.x));
    s.ay[k] = load.fy * inverse_mass + s.gravity.y - s.drag * (d.vy - my.at(d.y));
    s.alpha[k] = turning * load.torque / inertia(d);
    s.vx[k] += kick * s.ax[k];
    s.vy[k] += kick * s.ay[k];
    s.omega[k] += kick * s.alpha[k];
  }
  move_walls(s, kick, ahead);
  const CellFrame after = cell_frame(s.domain);
  // A way made during the step is carried along by the cell for half of it, on average.
  const double way_x = dt * (1 + 0.5 * after.growth_x(before)), way_y = dt * (1 + 0.5 * after.growth_y(before));
  const AffineMotion nx = affine_x(s.domain), ny = affine_y(s.domain);
  for (std::size_t k = 0; k < s.count; ++k) {
    DiskRecord& d = s.record[k];
    d.x = after.x_from(before, d.x) + way_x * s.vx[k];
    d.y = after.y_from(before, d.y) + way_y * s.vy[k];
    s.angle[k] += dt * s.omega[k];
    d.vx = s.vx[k] + ahead * s.ax[k] + nx.at(d.x);
    d.vy = s.vy[k] + ahead * s.ay[k] + ny.at(d.y);
    d.omega = s.omega[k] + ahead * s.alpha[k];
  }
  if (s.domain.periodic_x) s.domain.tilt *= after.width / before.width;
  s.lag = 0.5 * dt;
  ++s.step;
}

}  // namespace arenite::dem
