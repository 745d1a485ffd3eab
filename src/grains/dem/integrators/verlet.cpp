#include "grains/dem/integrators/integrators.hpp"

#include <atomic>

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/neighbours.hpp"
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

/// See integrators.hpp for `extrapolation`, its c.
template <int extrapolation> bool verlet(Sample& s, const Team& team) {
  const double kick = s.lag + 0.5 * s.dt, ahead = extrapolation * 0.5 * s.dt;
  DiskSweep sweep(s);
  sweep.task.kick = kick;
  sweep.task.ahead = ahead;
  move_walls(s, kick, ahead);
  push_boundaries(s, kick, ahead);
  s.lag = 0.5 * s.dt;
  return sweep.run(s.kernel->verlet, team);
}

}  // namespace

const Integrator velocity_verlet{{"velocity_verlet", "second order, the most robust"}, verlet<1>, nullptr, 0, 0, 0.5, 0.25, 1, 2};
const Integrator leapfrog{{"leapfrog", "second order, velocities half a step off"}, verlet<0>, nullptr, 0, 0, 1, 0.25, 0.5, 2};

namespace {

/// Where the cell has taken places in x (or y) since `then`.
Stretch stretch_x(const CellFrame& then, const CellFrame& now) {
  if (!now.periodic_x) return {};
  return {then.left_edge, now.width / then.width, now.left_edge};
}
Stretch stretch_y(const CellFrame& then, const CellFrame& now) {
  if (!now.periodic_y) return {};
  return {then.bottom_edge, now.height / then.height, now.bottom_edge};
}

}  // namespace

DiskSweep::DiskSweep(Sample& s)
    : task{s.record.data(),
           s.list.force.data(),
           s.list.group.data(),
           s.list.first.data(),
           s.vx.data(),
           s.vy.data(),
           s.omega.data(),
           s.angle.data(),
           s.ax.data(),
           s.ay.data(),
           s.alpha.data(),
           {},
           s.listed_x.data(),
           s.listed_y.data(),
           {},
           {},
           s.dt,
           0,
           0,
           s.drag,
           s.integration.rotations ? 1.0 : 0.0,
           0,
           0,
           0},
      sample_(s),
      before_(cell_frame(s.domain)) {
  for (std::size_t n = 0; n < s.higher.size(); ++n) task.higher[n] = s.higher[n].data();
  task.x.gravity = s.gravity.x;
  task.y.gravity = s.gravity.y;
  task.x.before = affine_x(s.domain);
  task.y.before = affine_y(s.domain);
}

bool DiskSweep::run(Kernel::Sweep loop, const Team& team) {
  Sample& s = sample_;
  const CellFrame after = cell_frame(s.domain), listed = cell_frame(s.listed_domain);
  task.x.after = affine_x(s.domain);
  task.y.after = affine_y(s.domain);
  task.x.moved = stretch_x(before_, after);
  task.y.moved = stretch_y(before_, after);
  task.x.listed = stretch_x(listed, after);
  task.y.listed = stretch_y(listed, after);
  task.x.growth = after.growth_x(before_);
  task.y.growth = after.growth_y(before_);
  move_boundaries(s, s.dt);
  s.sheared += s.dt * s.shear_rate;
  task.listed_shear = s.sheared - s.listed_sheared;
  task.middle = 0.5 * (s.domain.wall[bottom].position + s.domain.wall[top].position);
  const double leeway = list_leeway(s);
  task.limit = leeway > 0 ? leeway * leeway : -1.0;
  std::atomic<bool> near = true;
  if (has_single_disks(s))
    team.for_ranges(s.count, [&](std::size_t begin, std::size_t end) {
      if (!loop(task, begin, end)) near = false;
    });
  if (s.domain.periodic_x) s.domain.tilt *= after.width / before_.width;
  s.domain.tilt += s.dt * s.shear_rate * s.domain.height();
  for (WallBody& body : s.wall) body.slid += s.dt * body.drive.slide;
  hold_grains(s);
  const bool bodies_near = move_bodies(s, task, team);
  ++s.step;
  return near && bodies_near;
}

}  // namespace arenite::dem
