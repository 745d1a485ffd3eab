#include "grains/dem/parts/rough_walls.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/error.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {

const HeldGrain* RoughWalls::find(std::int32_t grain) const {
  const auto at =
      std::lower_bound(held.begin(), held.end(), grain, [](const HeldGrain& h, std::int32_t g) { return h.grain < g; });
  return at != held.end() && at->grain == grain ? &*at : nullptr;
}

void RoughWalls::number(Sample& s) {
  disk.assign(held.size(), 0);
  angle.assign(held.size(), 0.0);
  if (held.empty()) return;
  for (std::size_t k = 0; k < s.count; ++k) {
    const HeldGrain* of = find(s.record[k].grain);
    if (!of) continue;
    const auto h = of - held.data();
    disk[h] = static_cast<std::int32_t>(k);
    angle[h] = s.angle[k];
  }
}

/// The grains have slid with their walls since the list was built.
void RoughWalls::renew(Sample& s) {
  for (std::size_t h = 0; h < held.size(); ++h)
    held[h].place[1 - axis_of(held[h].side)] = along(held[h].side, s.record[disk[h]].place) - s.wall[held[h].side].slid;
}

void RoughWalls::hold(Sample& s) const {
  for (std::size_t h = 0; h < held.size(); ++h) {
    const HeldGrain& of = held[h];
    const std::int32_t k = disk[h];
    const WallBody& body = s.wall[of.side];
    const Wall& wall = s.domain.wall[of.side];
    DiskRecord& d = s.record[k];
    d.place = of.place + of_side(of.side, wall.position, body.slid);
    d.velocity = of_side(of.side, wall.velocity, body.drive.slide);
    s.velocity.put(k, of_side(of.side, body.rate, body.drive.slide));
    s.acceleration.put(k, Vec2{});
    s.angle[k] = angle[h];
    d.omega = s.omega[k] = s.alpha[k] = 0;
    for (auto& higher : s.higher)
      if (higher.size() > 0) higher.put(k, Vec3{});
  }
}

void RoughWalls::add_to_walls(Sample& s) const {
  for (std::size_t h = 0; h < held.size(); ++h)
    push_wall(s, held[h].side, -contact_load(slot_forces(s.list), disk[h]).force);
}

namespace {

/// Grains nearer to a rough wall than half their radius go with it from now on; one that was held before stays.
void hold_nearest(Sample& s) {
  RoughWalls& walls = the<RoughWalls>(s);
  std::vector<HeldGrain> held;
  for (std::size_t k = 0; k < s.count; ++k) {
    const DiskRecord& d = s.record[k];
    const HeldGrain* before = walls.find(d.grain);
    for (int side = 0; side < sides; ++side) {
      const double plane = s.domain.wall[side].position, slid = s.wall[side].slid;
      if (!s.wall[side].rough || (before ? before->side != side : s.domain.depth(side, d.place) > 1.5 * d.radius))
        continue;
      held.push_back({d.grain, side, d.place - of_side(side, plane, slid)});
      break;
    }
  }
  std::sort(held.begin(), held.end(), [](const HeldGrain& a, const HeldGrain& b) { return a.grain < b.grain; });
  walls.held = std::move(held);
  walls.number(s);
  walls.hold(s);
}

}  // namespace

void set_rough(Sample& s, const BySide<bool>& rough, const ThreadPool& pool) {
  if (std::ranges::equal(rough, s.wall, {}, {}, &WallBody::rough)) return;
  if (!has_disks_only(s))
    throw InputError("rough walls work with disks only; use smooth walls with friction for clumps and polygons");
  synchronise(s);
  for (int side = 0; side < sides; ++side) s.wall[side].rough = rough[side] && s.domain.wall[side].present;
  hold_nearest(s);
  list_anew(s, pool);
}

}  // namespace arenite::dem
