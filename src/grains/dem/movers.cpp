#include "grains/dem/movers.hpp"

#include <algorithm>
#include <atomic>

#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

template <int D> SweepTask<D> sweep_task(SampleIn<D>& s, double kick, double ahead) {
  SweepTask<D> task{};
  task.record = s.record.data();
  task.slots = slot_forces(s.list);
  task.velocity = s.velocity.data(), task.acceleration = s.acceleration.data(), task.listed = s.listed.data();
  task.omega = s.omega.data(), task.angle = s.angle.data(), task.alpha = s.alpha.data();
  std::ranges::transform(s.higher, task.higher.begin(), [](auto& derivatives) { return derivatives.data(); });
  task.gravity = s.gravity;
  task.before = cell_motion(s.domain);
  task.dt = s.dt;
  task.kick = kick;
  task.ahead = ahead;
  task.drag = s.drag;
  task.turning = s.integration.rotations ? 1.0 : 0.0;
  return task;
}

/// How far a disk may be from its place in the list, less the affine motion of the cell, before the list may miss a
/// contact, m; 0 or less if the walls or the cell have moved too far for that.
template <int D> double list_leeway(const SampleIn<D>& s) {
  for (int side = 0; side < sides_in<D>; ++side)
    if (!s.domain.is_periodic(side) &&
        std::abs(s.domain.wall[side].position - s.listed_domain.wall[side].position) > 0.5 * s.skin)
      return 0;
  if (any_part(s, [&](const auto& part) { return part.way_since_listed(s) > 0.5 * s.skin; })) return 0;
  const CellFrame<D> then = cell_frame(s.listed_domain), now = cell_frame(s.domain);
  double growth = 0;
  for (std::size_t axis = 0; axis < now.size(); ++axis) growth += std::abs(now[axis].since(then[axis]).growth());
  return 0.5 * (s.skin - reach_of(s) * (growth + std::abs(s.sheared - s.listed_sheared)));
}

}  // namespace

template <int D> void kick_walls(SampleIn<D>& s, double kick, double ahead) {
  const auto accelerations = wall_accelerations(s);
  for (int side = 0; side < sides_in<D>; ++side) {
    WallBodyIn<D>& body = s.wall[side];
    WallIn<D>& wall = s.domain.wall[side];
    body.acceleration = accelerations[side];
    body.rate += kick * body.acceleration;
    wall.position += s.dt * body.rate;
    wall.velocity = body.rate + ahead * body.acceleration;
  }
  each_part(s, [&](auto& part) { part.kick(s, kick, ahead); });
}

template <int D> bool make_step(SampleIn<D>& s, const ThreadPool& pool) {
  const Integrator& scheme = integrator_of(s);
  const double lag = scheme.lag * s.dt, kick = s.dt - lag + s.lag, ahead = scheme.ahead * s.dt;
  s.lag = lag;
  const CellFrame<D> before = cell_frame(s.domain), listed = cell_frame(s.listed_domain);
  SweepTask<D> task = sweep_task(s, kick, ahead);
  std::get<OwnSteps<D>>(scheme.own).move_walls(s, kick, ahead);
  const CellFrame<D> after = cell_frame(s.domain);
  for (std::size_t axis = 0; axis < after.size(); ++axis) {
    task.moved[axis] = after[axis].since(before[axis]);
    task.listed_moved[axis] = after[axis].since(listed[axis]);
  }
  task.after = cell_motion(s.domain);
  each_part(s, [&](auto& part) { part.move(s, s.dt); });
  s.sheared += s.dt * s.shear_rate;
  task.listed_shear = s.sheared - s.listed_sheared;
  task.middle = 0.5 * (s.domain.wall[bottom].position + s.domain.wall[top].position);
  const double leeway = list_leeway(s);
  task.limit = leeway > 0 ? leeway * leeway : -1.0;
  const auto loop = s.kernel->sweeps[static_cast<std::size_t>(s.integration.integrator)];
  std::atomic<bool> near = true;
  if (!any_part(s, [&](const auto& part) { return part.moves_all_disks(s); }))
    pool.for_ranges(s.count, [&](std::size_t begin, std::size_t end) {
      if (!loop(task, begin, end)) near = false;
    });
  if (s.domain.periodic[0]) s.domain.tilt *= after[0].length / before[0].length;
  s.domain.tilt += s.dt * s.shear_rate * s.domain.extent(1);
  for (WallBodyIn<D>& body : s.wall) body.slid += s.dt * body.drive.slide;
  each_part(s, [&](auto& part) {
    if (!part.follow(s, task, pool)) near = false;
  });
  ++s.step;
  return near;
}

template <int D> double time_behind(const SampleIn<D>& s) {
  if (integrator_of(s).corrects()) return s.settled ? 0.5 * s.dt : 0.0;
  return s.lag;
}

template <int D> Vec<D> velocity_beside(const SampleIn<D>& s, std::size_t i, std::size_t j, Vec<D> image) {
  const CellMotion<D> cell = cell_motion(s.domain);
  return s.velocity[i] + cell.at(s.record[i].place) - s.velocity[j] - cell.at(s.record[j].place) - image;
}

template void kick_walls(SampleIn<2>&, double, double);
template void kick_walls(SampleIn<3>&, double, double);
template bool make_step(SampleIn<2>&, const ThreadPool&);
template bool make_step(SampleIn<3>&, const ThreadPool&);
template double time_behind(const SampleIn<2>&);
template double time_behind(const SampleIn<3>&);
template Vec2 velocity_beside(const SampleIn<2>&, std::size_t, std::size_t, Vec2);
template Vec3 velocity_beside(const SampleIn<3>&, std::size_t, std::size_t, Vec3);

}  // namespace arenite::dem
