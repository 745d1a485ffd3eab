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
template <int extrapolation> bool verlet(Sample& s, const ThreadPool& pool) {
  const double kick = s.lag + 0.5 * s.dt, ahead = extrapolation * 0.5 * s.dt;
  DiskSweep sweep(s);
  sweep.task.kick = kick;
  sweep.task.ahead = ahead;
  move_walls(s, kick, ahead);
  push_boundaries(s, kick, ahead);
  s.lag = 0.5 * s.dt;
  return sweep.run(s.kernel->verlet, pool);
}

}  // namespace

const Integrator velocity_verlet{{"velocity_verlet", "second order, the most robust"}, verlet<1>, nullptr, 0, 0, 0.5, 0.25, 1, 2};
const Integrator leapfrog{{"leapfrog", "second order, velocities half a step off"}, verlet<0>, nullptr, 0, 0, 1, 0.25, 0.5, 2};

DiskSweep::DiskSweep(Sample& s) : sample_(s), before_(cell_frame(s.domain)) {
  task.record = s.record.data();
  task.force = s.list.force.data();
  task.group = s.list.group.data();
  task.first = s.list.first.data();
  task.vx = s.vx.data();
  task.vy = s.vy.data();
  task.omega = s.omega.data();
  task.angle = s.angle.data();
  task.ax = s.ax.data();
  task.ay = s.ay.data();
  task.alpha = s.alpha.data();
  for (std::size_t n = 0; n < s.higher.size(); ++n) task.higher[n] = s.higher[n].data();
  task.listed_x = s.listed_x.data();
  task.listed_y = s.listed_y.data();
  const CellMotion motion = cell_motion(s.domain);
  task.x = {s.gravity.x, motion.x, {}, {}, {}, 0};
  task.y = {s.gravity.y, motion.y, {}, {}, {}, 0};
  task.dt = s.dt;
  task.drag = s.drag;
  task.turning = s.integration.rotations ? 1.0 : 0.0;
}

bool DiskSweep::run(Kernel::Sweep loop, const ThreadPool& pool) {
  Sample& s = sample_;
  const CellFrame after = cell_frame(s.domain), listed = cell_frame(s.listed_domain);
  const CellMotion motion = cell_motion(s.domain);
  task.x = {task.x.gravity, task.x.before, motion.x, after.x.since(before_.x), after.x.since(listed.x), after.x.growth(before_.x)};
  task.y = {task.y.gravity, task.y.before, motion.y, after.y.since(before_.y), after.y.since(listed.y), after.y.growth(before_.y)};
  move_boundaries(s, s.dt);
  s.sheared += s.dt * s.shear_rate;
  task.listed_shear = s.sheared - s.listed_sheared;
  task.middle = 0.5 * (s.domain.wall[bottom].position + s.domain.wall[top].position);
  const double leeway = list_leeway(s);
  task.limit = leeway > 0 ? leeway * leeway : -1.0;
  std::atomic<bool> near = true;
  if (has_single_disks(s))
    pool.for_ranges(s.count, [&](std::size_t begin, std::size_t end) {
      if (!loop(task, begin, end)) near = false;
    });
  if (s.domain.periodic[0]) s.domain.tilt *= after.x.length / before_.x.length;
  s.domain.tilt += s.dt * s.shear_rate * s.domain.height();
  for (WallBody& body : s.wall) body.slid += s.dt * body.drive.slide;
  hold_grains(s);
  const bool bodies_near = move_bodies(s, task, pool);
  ++s.step;
  return near && bodies_near;
}

}  // namespace arenite::dem
