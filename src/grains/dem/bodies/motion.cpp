#include "grains/dem/bodies/motion.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "grains/dem/neighbours.hpp"
#include "grains/dem/sample.hpp"
#include "model/shapes.hpp"

namespace arenite::dem {
namespace {

template <class Use> void for_parts(const Sample& s, const Body& b, Use use) {
  for (auto d = static_cast<std::size_t>(b.first); d < static_cast<std::size_t>(b.first + b.count); ++d)
    use(d, static_cast<std::size_t>(the<Bodies>(s).disk[d]));
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

}  // namespace

void place_parts_of(Sample& s, const Body& b) {
  const Vec2 by = direction(b.angle);
  for_parts(s, b, [&](std::size_t d, std::size_t k) {
    const Vec2 arm = the<Bodies>(s).lever[k] = turned(the<Bodies>(s).part[d].place, by);
    DiskRecord& disk = s.record[k];
    disk.place = b.place + arm + s.domain.way(the<Bodies>(s).part[d].shift);
    disk.velocity =
        b.seen.velocity + b.seen.omega * perpendicular(arm) + image_velocity(s, the<Bodies>(s).part[d].shift);
    s.velocity.put(k, disk.velocity);
    s.omega[k] = disk.omega = b.seen.omega;
    s.angle[k] = b.angle;
  });
}

Load<2> load_of(const Sample& s, const Body& b) {
  const SlotForces<2> slots = slot_forces(s.list);
  Load<2> sum;
  for_parts(s, b, [&](std::size_t, std::size_t k) {
    const Load<2> load = contact_load(slots, k);
    sum.force += load.force;
    sum.torque += load.torque + cross(the<Bodies>(s).lever[k], load.force);
  });
  return sum;
}

void number_parts(Sample& s) {
  if (the<Bodies>(s).part.empty()) return;
  std::ranges::fill(the<Bodies>(s).lever, Vec2{});  // of disks that are grains by themselves
  for (std::size_t k = 0; k < s.count; ++k) the<Bodies>(s).disk[s.record[k].grain] = static_cast<std::int32_t>(k);
  for (const Body& b : the<Bodies>(s).body) {
    const Vec2 by = direction(b.angle);
    for_parts(s, b, [&](std::size_t d, std::size_t k) {
      the<Bodies>(s).lever[k] = turned(the<Bodies>(s).part[d].place, by);
    });
  }
}

bool move_bodies(Sample& s, const SweepTask<2>& t, const ThreadPool& pool) {
  if (the<Bodies>(s).body.empty()) return true;
  std::atomic<bool> near = true;
  pool.for_ranges(the<Bodies>(s).body.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      move(s, t, the<Bodies>(s).body[b]);
      place_parts_of(s, the<Bodies>(s).body[b]);
      if (!are_near(s, t, the<Bodies>(s).body[b])) near = false;
    }
  });
  return near;
}

void wrap_bodies(Sample& s) {
  for (Body& b : the<Bodies>(s).body) {
    wrap_over_sides(s, b.mass, b.place, b.own.velocity.x, b.seen.velocity);
    const Vec2 by = direction(b.angle);
    for_parts(s, b, [&](std::size_t d, std::size_t) { wrap_part(s, b, by, the<Bodies>(s).part[d]); });
  }
  place_parts(s);
}

}  // namespace arenite::dem
