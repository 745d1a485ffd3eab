#include "grains/dem/movers.hpp"

#include <atomic>

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

SweepTask<2> sweep_task(Sample& s, double kick, double ahead) {
  SweepTask<2> task{};
  task.record = s.record.data();
  task.slots = slot_forces(s.list);
  const auto point = [](auto& to, auto& from) {
    for (std::size_t n = 0; n < to.size(); ++n) to[n] = from.along[n].data();
  };
  point(task.velocity, s.velocity);
  point(task.acceleration, s.acceleration);
  point(task.listed, s.listed);
  for (std::size_t n = 0; n < s.higher.size(); ++n) point(task.higher[n], s.higher[n]);
  task.omega = {s.omega.data()};
  task.angle = {s.angle.data()};
  task.alpha = {s.alpha.data()};
  task.gravity = s.gravity;
  task.before = cell_motion(s.domain);
  task.dt = s.dt;
  task.kick = kick;
  task.ahead = ahead;
  task.drag = s.drag;
  task.turning = s.integration.rotations ? 1.0 : 0.0;
  return task;
}

}  // namespace

void kick_walls(Sample& s, double kick, double ahead) {
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

bool make_step(Sample& s, const ThreadPool& pool) {
  const Integrator& scheme = integrator_of(s);
  const double lag = scheme.lag * s.dt, kick = s.dt - lag + s.lag, ahead = scheme.ahead * s.dt;
  s.lag = lag;
  const CellFrame<2> before = cell_frame(s.domain), listed = cell_frame(s.listed_domain);
  SweepTask<2> task = sweep_task(s, kick, ahead);
  scheme.move_walls(s, kick, ahead);
  const CellFrame<2> after = cell_frame(s.domain);
  for (std::size_t axis = 0; axis < after.size(); ++axis) {
    task.moved[axis] = after[axis].since(before[axis]);
    task.listed_moved[axis] = after[axis].since(listed[axis]);
  }
  task.after = cell_motion(s.domain);
  move_boundaries(s, s.dt);
  s.sheared += s.dt * s.shear_rate;
  task.listed_shear = s.sheared - s.listed_sheared;
  task.middle = 0.5 * (s.domain.wall[bottom].position + s.domain.wall[top].position);
  const double leeway = list_leeway(s);
  task.limit = leeway > 0 ? leeway * leeway : -1.0;
  const Kernel::Sweep loop = s.kernel->sweeps[static_cast<std::size_t>(s.integration.integrator)];
  std::atomic<bool> near = true;
  if (has_single_disks(s))
    pool.for_ranges(s.count, [&](std::size_t begin, std::size_t end) {
      if (!loop(task, begin, end)) near = false;
    });
  if (s.domain.periodic[0]) s.domain.tilt *= after[0].length / before[0].length;
  s.domain.tilt += s.dt * s.shear_rate * s.domain.height();
  for (WallBody& body : s.wall) body.slid += s.dt * body.drive.slide;
  hold_grains(s);
  const bool bodies_near = move_bodies(s, task, pool);
  ++s.step;
  return near && bodies_near;
}

Acceleration acceleration_of(const Sample& s, std::size_t k) {
  if (k < s.count && find_held(s, s.record[k].grain)) return {};
  const Load<2> load = load_on(s, k);
  const Mover m = mover_at(s, k);
  return {load.force / m.mass + s.gravity - s.drag * (m.seen.velocity - cell_motion(s.domain).at(m.place)),
          s.integration.rotations ? load.torque / m.inertia : 0.0};
}

namespace {

/// What integrated rates and places lack, as so many times the acceleration that a scheme has not foreseen: s and s^2.
struct Behind {
  double rate = 0, place = 0;
};
Behind behind(const Sample& s) {
  const Integrator& scheme = integrator_of(s);
  if (!scheme.corrects()) return {s.lag, 0};
  if (!s.settled) return {};
  return {0.5 * scheme.velocity_share * s.dt, 0.5 * scheme.position_share * s.dt * s.dt};
}

Acceleration unforeseen(const Sample& s, std::size_t k) {
  const Acceleration a = acceleration_of(s, k);
  if (!integrator_of(s).corrects()) return a;
  return {a.linear - s.acceleration[k], a.alpha - s.alpha[k]};
}

double unforeseen_of_wall(const Sample& s, std::size_t side) {
  const double a = wall_acceleration(s, side, s.domain.wall[side].velocity);
  return integrator_of(s).corrects() ? a - s.wall[side].acceleration : a;
}

}  // namespace

Motion<2> motion_of(const Sample& s, std::size_t k) {
  const Motion<2> own = mover_at(s, k).own;
  const double lag = behind(s).rate;
  if (lag == 0) return own;
  const Acceleration a = unforeseen(s, k);
  return {own.velocity + lag * a.linear, own.omega + lag * a.alpha};
}

Vec2 place_of(const Sample& s, std::size_t k) {
  const Vec2 place = mover_at(s, k).place;
  const double lag = behind(s).place;
  return lag == 0 ? place : place + lag * unforeseen(s, k).linear;
}

double wall_rate(const Sample& s, std::size_t side) { return s.wall[side].rate + behind(s).rate * unforeseen_of_wall(s, side); }

Domain domain_now(const Sample& s) {
  Domain domain = s.domain;
  for (int side = 0; side < sides; ++side) {
    domain.wall[side].velocity = wall_rate(s, side);
    domain.wall[side].position += behind(s).place * unforeseen_of_wall(s, side);
  }
  for (std::size_t b = 0; b < s.boundary.size(); ++b) domain.boundaries[b].velocity = velocity_of(s, b);
  return domain;
}

double time_behind(const Sample& s) {
  if (integrator_of(s).corrects()) return s.settled ? 0.5 * s.dt : 0.0;
  return s.lag;
}

Vec2 velocity_beside(const Sample& s, std::size_t i, std::size_t j, Vec2 image) {
  const CellMotion<2> cell = cell_motion(s.domain);
  return s.velocity[i] + cell.at(s.record[i].place) - s.velocity[j] - cell.at(s.record[j].place) - image;
}

}  // namespace arenite::dem
