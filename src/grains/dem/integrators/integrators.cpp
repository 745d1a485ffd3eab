#include "grains/dem/integrators/integrators.hpp"

#include <atomic>
#include <vector>

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {

std::string integrators_of_bodies(std::string_view quotes) {
  std::vector<std::string> names;
  for (const Integrator* scheme : integrators)
    if (scheme->moves_bodies) names.push_back(std::string(quotes).append(scheme->word.word).append(quotes));
  std::string text = names.front();
  for (std::size_t k = 1; k < names.size(); ++k) text += (k + 1 < names.size() ? ", " : " or ") + names[k];
  return text;
}

namespace {

SweepTask sweep_task(Sample& s, double kick, double ahead) {
  SweepTask task{};
  task.record = s.record.data();
  task.force = s.list.force.data();
  task.group = s.list.group.data();
  task.first = s.list.first.data();
  const auto point = [](auto& to, auto& from) {
    for (std::size_t n = 0; n < to.size(); ++n) to[n] = from.along[n].data();
  };
  point(task.velocity, s.velocity);
  point(task.acceleration, s.acceleration);
  point(task.listed, s.listed);
  for (std::size_t n = 0; n < s.higher.size(); ++n) point(task.higher[n], s.higher[n]);
  task.omega = s.omega.data();
  task.angle = s.angle.data();
  task.alpha = s.alpha.data();
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

bool sweep_disks(Sample& s, const ThreadPool& pool, Kernel::Sweep loop, MoveWalls move_walls, double kick, double ahead) {
  const CellFrame<2> before = cell_frame(s.domain), listed = cell_frame(s.listed_domain);
  SweepTask task = sweep_task(s, kick, ahead);
  move_walls(s, kick, ahead);
  const CellFrame<2> after = cell_frame(s.domain);
  for (std::size_t axis = 0; axis < after.size(); ++axis)
    task.cell[axis] = {after[axis].since(before[axis]), after[axis].since(listed[axis]), after[axis].growth(before[axis])};
  task.after = cell_motion(s.domain);
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
  if (s.domain.periodic[0]) s.domain.tilt *= after[0].length / before[0].length;
  s.domain.tilt += s.dt * s.shear_rate * s.domain.height();
  for (WallBody& body : s.wall) body.slid += s.dt * body.drive.slide;
  hold_grains(s);
  const bool bodies_near = move_bodies(s, task, pool);
  ++s.step;
  return near && bodies_near;
}

}  // namespace arenite::dem
