#include "grains/dem/parts/rough_walls.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/error.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {

template <int D> const HeldGrainIn<D>* RoughWallsIn<D>::find(std::int32_t grain) const {
  const auto at = std::ranges::lower_bound(held, grain, {}, &HeldGrainIn<D>::grain);
  return at != held.end() && at->grain == grain ? &*at : nullptr;
}

template <int D> void RoughWallsIn<D>::number(SampleIn<D>& s) {
  disk.assign(held.size(), 0);
  angle.assign(held.size());
  if (held.empty()) return;
  for (std::size_t k = 0; k < s.count; ++k) {
    const HeldGrainIn<D>* of = find(s.record[k].grain);
    if (!of) continue;
    const auto h = of - held.data();
    disk[h] = static_cast<std::int32_t>(k);
    angle.put(static_cast<std::size_t>(h), s.angle[k]);
  }
}

/// The grains have slid with their walls since the list was built.
template <int D> void RoughWallsIn<D>::renew(SampleIn<D>& s) {
  for (std::size_t h = 0; h < held.size(); ++h) {
    HeldGrainIn<D>& of = held[h];
    of.place =
        of_side(of.side, across<D>(of.side, of.place), along(of.side, s.record[disk[h]].place) - s.wall[of.side].slid);
  }
}

template <int D> void RoughWallsIn<D>::hold(SampleIn<D>& s) const {
  for (std::size_t h = 0; h < held.size(); ++h) {
    const HeldGrainIn<D>& of = held[h];
    const std::int32_t k = disk[h];
    const WallBodyIn<D>& body = s.wall[of.side];
    const WallIn<D>& wall = s.domain.wall[of.side];
    GrainRecord<D>& d = s.record[k];
    d.place = of.place + of_side(of.side, wall.position, body.slid);
    d.velocity = of_side(of.side, wall.velocity, body.drive.slide);
    s.velocity.put(k, of_side(of.side, body.rate, body.drive.slide));
    s.acceleration.put(k, Vec<D>{});
    s.angle.put(k, angle[h]);
    d.omega = {};
    s.omega.put(k, Turning<D>{});
    s.alpha.put(k, Turning<D>{});
    for (auto& higher : s.higher)
      if (higher.size() > 0) higher.put(k, Vec3{});
  }
}

template <int D> void RoughWallsIn<D>::add_to_walls(SampleIn<D>& s) const {
  for (std::size_t h = 0; h < held.size(); ++h)
    push_wall<D>(s, held[h].side, -contact_load(slot_forces(s.list), disk[h]).force);
}

namespace {

/// Grains nearest to a rough wall go with it from now on; one that was held before stays.
template <int D> void hold_nearest(SampleIn<D>& s) {
  RoughWallsIn<D>& walls = the<RoughWallsIn<D>>(s);
  std::vector<HeldGrainIn<D>> held;
  for (std::size_t k = 0; k < s.count; ++k) {
    const GrainRecord<D>& d = s.record[k];
    const HeldGrainIn<D>* before = walls.find(d.grain);
    for (int side = 0; side < sides_in<D>; ++side) {
      const double plane = s.domain.wall[side].position;
      const Along<D> slid = s.wall[side].slid;
      const double reach = (1 + rough_reach) * d.radius;
      if (!s.wall[side].rough || (before ? before->side != side : s.domain.depth(side, d.place) > reach)) continue;
      held.push_back({d.grain, side, d.place - of_side(side, plane, slid)});
      break;
    }
  }
  std::ranges::sort(held, {}, &HeldGrainIn<D>::grain);
  walls.held = std::move(held);
  walls.number(s);
  walls.hold(s);
}

}  // namespace

template <int D> void set_rough(SampleIn<D>& s, const ByAnySide<bool>& rough, const ThreadPool& pool) {
  ByAnySide<bool> before{};
  std::ranges::transform(s.wall, before.begin(), &WallBodyIn<D>::rough);
  if (rough == before) return;
  if (!has_disks_only(s))
    throw InputError("rough walls work with disks only; use smooth walls with friction for clumps and polygons");
  synchronise(s);
  for (int side = 0; side < sides_in<D>; ++side) s.wall[side].rough = rough[side] && s.domain.wall[side].present;
  hold_nearest(s);
  list_anew(s, pool);
}

template struct RoughWallsIn<2>;
template struct RoughWallsIn<3>;
template void set_rough(SampleIn<2>&, const ByAnySide<bool>&, const ThreadPool&);
template void set_rough(SampleIn<3>&, const ByAnySide<bool>&, const ThreadPool&);

}  // namespace arenite::dem
