#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/neighbours.hpp"
#include "model/shapes.hpp"

namespace arenite::dem {
namespace {

template <class Use> void for_parts(const Sample& s, const Body& b, Use use) {
  for (auto d = static_cast<std::size_t>(b.first); d < static_cast<std::size_t>(b.first + b.count); ++d)
    use(d, static_cast<std::size_t>(s.part_disk[d]));
}

void place_parts_of(Sample& s, const Body& b) {
  const Vec2 by = direction(b.angle);
  for_parts(s, b, [&](std::size_t d, std::size_t k) {
    const Vec2 arm = s.lever[k] = turned(s.part[d].place, by);
    DiskRecord& disk = s.record[k];
    disk.place = b.place + arm + s.domain.way(s.part[d].shift);
    disk.velocity = b.seen.velocity + b.seen.omega * perpendicular(arm) + image_velocity(s, s.part[d].shift);
    s.velocity.put(k, disk.velocity);
    s.omega[k] = disk.omega = b.seen.omega;
    s.angle[k] = b.angle;
  });
}

/// By its disks' contacts.
Load<2> load_of(const Sample& s, const Body& b) {
  const SlotForces<2> slots = slot_forces(s.list);
  Load<2> sum;
  for_parts(s, b, [&](std::size_t, std::size_t k) {
    const Load<2> load = contact_load(slots, k);
    sum.force += load.force;
    sum.torque += load.torque + cross(s.lever[k], load.force);
  });
  return sum;
}

/// Step (kernels/sweep.hpp) for a body.
void move(const Sample& s, const SweepTask<2>& t, Body& b) {
  const Load<2> load = load_of(s, b);
  const Vec2 a = load.force / b.mass + t.gravity - t.drag * (b.seen.velocity - t.before.at(b.place));
  const double alpha = t.turning * load.torque / b.inertia();
  b.own.velocity += t.kick * a;
  b.own.omega += t.kick * alpha;
  b.angle += t.dt * b.own.omega;
  for (int axis = 0; axis < 2; ++axis)
    b.place[axis] =
        t.moved[axis].apply(b.place[axis]) + t.dt * (1 + 0.5 * t.moved[axis].growth()) * b.own.velocity[axis];
  b.seen = {b.own.velocity + t.ahead * a + t.after.at(b.place), b.own.omega + t.ahead * alpha};
}

/// Whether the disks of a body are near enough to their places in the list.
bool are_near(const Sample& s, const SweepTask<2>& t, const Body& b) {
  bool near = true;
  for_parts(s, b, [&](std::size_t, std::size_t k) {
    const DiskRecord& d = s.record[k];
    const Vec2 way = way_since_listed(t, d.place, by_axis<2>([&](int axis) { return t.listed[axis][k]; }));
    near = near && dot(way, way) <= t.limit;
  });
  return near;
}

/// Cells between a disk and its body's centre, so that both lie in the cell.
void wrap_part(const Sample& s, const Body& b, Vec2 by, BodyDisk& part) {
  part.shift = -s.domain.cell_of(b.place + turned(part.place, by));
}

/// Torque about the disk of a foot's polygon that takes it, by the way from there to the foot, where the slot's force
/// acts.
double shifted_torque(const Sample& s, std::size_t slot, const Foot& foot) {
  const Vec2 on_i = s.list.force[slot].on_i;
  if (is_boundary(foot.touches)) return cross(foot.lever - s.lever[s.list.i[slot]], on_i);
  return cross(foot.lever - s.lever[s.list.owner[slot]], -on_i);
}

}  // namespace

Load<2> load_on(const Sample& s, std::size_t mover) {
  return mover < s.count ? contact_load(slot_forces(s.list), mover) : load_of(s, s.body[mover - s.count]);
}

void number_parts(Sample& s) {
  if (s.part.empty()) return;
  std::ranges::fill(s.lever, Vec2{});  // of disks that are grains by themselves
  for (std::size_t k = 0; k < s.count; ++k) s.part_disk[s.record[k].grain] = static_cast<std::int32_t>(k);
  for (const Body& b : s.body) {
    const Vec2 by = direction(b.angle);
    for_parts(s, b, [&](std::size_t d, std::size_t k) { s.lever[k] = turned(s.part[d].place, by); });
  }
}

bool disks_meet(const Sample& s, std::int32_t i, std::int32_t j) {
  const std::int32_t a = body_of(s, s.record[i].grain), b = body_of(s, s.record[j].grain);
  const auto is_corner = [&](std::int32_t body) { return body >= 0 && s.body[body].filled != 0; };
  return !is_corner(a) && !is_corner(b) && (a < 0 || a != b);
}

bool move_bodies(Sample& s, const SweepTask<2>& t, const ThreadPool& pool) {
  if (s.body.empty()) return true;
  std::atomic<bool> near = true;
  pool.for_ranges(s.body.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      move(s, t, s.body[b]);
      place_parts_of(s, s.body[b]);
      if (!are_near(s, t, s.body[b])) near = false;
    }
  });
  return near;
}

void place_parts(Sample& s) {
  for (const Body& b : s.body) place_parts_of(s, b);
}

void wrap_bodies(Sample& s) {
  for (Body& b : s.body) {
    wrap_over_sides(s, b.mass, b.place, b.own.velocity.x, b.seen.velocity);
    const Vec2 by = direction(b.angle);
    for_parts(s, b, [&](std::size_t d, std::size_t) { wrap_part(s, b, by, s.part[d]); });
  }
  place_parts(s);
}

void take_torques_to_owners(Sample& s, const ThreadPool& pool) {
  const std::size_t feet = s.foot.size(), first = s.list.pairs - feet, points = s.point_foot.size();
  if (feet + points == 0) return;
  pool.for_ranges(feet + points, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const std::size_t slot = n < feet ? first + n : s.list.polygons + n - feet;
      SlotForce<2>& force = s.list.force[slot];
      if (acts(force)) (n < feet ? force.torque_j : force.torque_i) += shifted_torque(s, slot, *foot_of(s, slot));
    }
  });
}

Levers<2> levers_of(const Sample& s, std::size_t slot) {
  if (s.part.empty()) return {};
  const Foot* foot = foot_of(s, slot);
  Levers<2> levers{s.lever[s.list.i[slot]], {}};
  if (s.list.j[slot] >= 0) levers.j = foot ? foot->lever : s.lever[s.list.owner[slot]];
  else if (foot) levers.i = foot->lever;
  return levers;
}

Torques own_torques(const Sample& s, std::size_t slot) {
  Torques torques{s.list.force[slot].torque_i, s.list.force[slot].torque_j};
  if (const Foot* foot = foot_of(s, slot))
    (is_boundary(foot->touches) ? torques.i : torques.j) -= shifted_torque(s, slot, *foot);
  return torques;
}

int rows_between(const Sample& s, std::size_t slot) {
  const std::int32_t j = s.list.j[slot], n = static_cast<std::int32_t>(s.count);
  if (j < 0) return 0;
  const Foot* foot = foot_of(s, slot);
  int rows = foot ? foot->shift.y : j >= n ? s.ghost[j - n].shift.y : 0;
  if (s.part.empty()) return rows;
  const auto shift = [&](std::int32_t k) { return s.part[s.record[k].grain].shift.y; };
  if (!foot) rows += shift(s.list.owner[slot]);
  return rows - shift(s.list.i[slot]);
}

Vec2 between_centres(const Sample& s, std::size_t slot, Vec2 branch) {
  const Levers<2> levers = levers_of(s, slot);
  return branch - levers.i + levers.j;
}

}  // namespace arenite::dem
