#include "grains/dem/contact_list.hpp"

#include <algorithm>

#include "geometry/cell_grid.hpp"
#include "grains/dem/glue.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/rolling.hpp"

namespace arenite::dem {
namespace {

/// Makes the images of the disks near the right and the upper edge of a periodic cell, with records behind those of the
/// disks: every pair across an edge then occurs once, as (disk, ghost).
template <int D> void make_ghosts(SampleIn<D>& s) {
  s.ghost.clear();
  s.record.resize(s.count);
  const double reach = reach_of(s);
  bool after = false;  // the cell of now
  s.domain.each_near_cell([&](Cells<D> cell) {
    for (std::size_t k = 0; after && k < s.count; ++k)
      if (s.domain.is_near(s.record[k].place + s.domain.way(cell), reach))
        s.ghost.push_back({static_cast<std::int32_t>(k), cell});
    after = after || cell == Cells<D>{};
  });
  s.images = s.ghost.size();
  s.record.resize(s.count + s.images);
  refresh_ghosts(s);
}

/// Whether the list must have a pair.
template <int D> bool are_near(const SampleIn<D>& s, const GrainRecord<D>& a, const GrainRecord<D>& b) {
  const Vec<D> d = a.place - b.place;
  const double reach = a.radius + b.radius + s.skin + reach_of_parts(s);
  return dot(d, d) < reach * reach;
}

template <int D> bool may_meet(const SampleIn<D>& s, std::int32_t i, std::int32_t j) {
  return !any_part(s, [&](const auto& part) { return !part.lets_meet(s, i, j); });
}

/// A disk and its partner, which comes after it or is a ghost.
struct NearPair {
  std::int32_t i, j;
};

/// All pairs, block by block: what a block finds does not depend on who searches it. Disks are sorted by cell, so their
/// partners are found in order.
template <int D> std::vector<std::vector<NearPair>> find_pairs(const SampleIn<D>& s, const ThreadPool& pool) {
  const auto grid = cells_of(s);
  const std::size_t n = s.count;
  const auto cell_of = [&](std::size_t k) { return grid.cell(s.record[k].place); };
  const geometry::SortedCells inner(grid.size(), 0, n, cell_of), images(grid.size(), n, s.record.size(), cell_of);
  const Vec<D> upper = s.domain.corner(1);
  const double reach = reach_of(s);
  return pool.by_blocks<std::vector<NearPair>>(n, disks_of_block, [&](std::size_t disk, std::vector<NearPair>& near) {
    const auto k = static_cast<std::int32_t>(disk);
    const GrainRecord<D>& a = s.record[disk];
    const auto before = static_cast<std::ptrdiff_t>(near.size());
    const auto look_at = [&](std::int32_t j) {
      if (are_near(s, a, s.record[j]) && may_meet(s, k, j)) near.push_back({k, j});
    };
    inner.for_later(grid, a.place, [&](std::int32_t begin, std::int32_t end) {
      for (std::int32_t j = std::max(begin, k + 1); j < end; ++j) look_at(j);
    });
    bool at_edge = false;  // ghosts lie beyond the right and the upper edge
    for (int axis = 0; axis < D; ++axis) at_edge = at_edge || a.place[axis] > upper[axis] - reach;
    if (!s.ghost.empty() && at_edge) {
      images.for_near(grid, a.place, look_at);
      std::ranges::sort(near.begin() + before, near.end(), {}, &NearPair::j);
    }
  });
}

template <int D> void list_pairs(SampleIn<D>& s, const ThreadPool& pool) {
  const std::vector<std::vector<NearPair>> blocks = find_pairs(s, pool);
  std::vector<std::size_t> first{0};
  for (const auto& block : blocks) first.push_back(first.back() + block.size());
  s.list.pairs = first.back();
  s.list.resize(first.back());
  const auto n = static_cast<std::int32_t>(s.count);
  pool.for_ranges(blocks.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin, slot = first[begin]; block < end; ++block)
      for (const auto& [i, j] : blocks[block])
        fill_slot(s.list, slot++, i, j, j < n ? j : s.ghost[j - n].source,
                  pair_coefficients(s, s.record[i], s.record[j]));
  });
}

/// Slots of walls and of what parts have beside them.
template <int D> void list_walls(SampleIn<D>& s) {
  std::vector<std::int32_t> near;
  for (std::size_t k = 0; k < s.count; ++k) {
    const GrainRecord<D>& d = s.record[k];
    near.clear();
    const int held = holding_side(s, d.grain);
    for (int side = 0; side < sides_in<D>; ++side)
      if (s.domain.wall[side].present && side != held && s.domain.depth(side, d.place) < d.radius + s.skin)
        near.push_back(wall_partner(side));
    each_part(s, [&](const auto& part) { part.find_near(s, k, near); });
    for (const std::int32_t j : near) add_slot(s.list, static_cast<std::int32_t>(k), j, -1, s.coefficients.wall(d));
  }
}

/// Fills list.group and list.first, see there.
template <int D> void group_slots(SampleIn<D>& s) {
  ContactListIn<D>& list = s.list;
  const auto none = static_cast<std::int32_t>(list.size());
  const auto groups = [](std::int32_t slots) { return 4 * std::max((slots + 3) / 4, 1); };
  const auto each = [&](const auto& see) {  // (place of its disk in list.first, slot)
    for (std::size_t p = 0; p < list.size(); ++p) {
      see(2 * list.i[p], p);
      if (list.owner[p] >= 0) see(2 * list.owner[p] + 1, p);
    }
    each_part(s, [&](const auto& part) {
      part.each_force([&](std::int32_t i, std::int32_t j, std::size_t n) {
        see(2 * i, place_of_force(list, part.first_force + n));
        see(2 * j + 1, place_of_force(list, part.first_force + n));
      });
    });
  };
  std::vector<std::int32_t> used(2 * s.count + 1, 0);
  each([&](std::int32_t q, std::size_t) { ++used[q]; });
  list.first.assign(2 * s.count + 1, 0);
  for (std::size_t q = 0; q < 2 * s.count; ++q) list.first[q + 1] = list.first[q] + groups(used[q]);
  list.group.assign(list.first.back(), none);
  std::vector<std::int32_t> next = list.first;
  each([&](std::int32_t q, std::size_t p) { list.group[next[q]++] = static_cast<std::int32_t>(p); });
}

}  // namespace

template <int D> void refresh_ghosts(SampleIn<D>& s) {
  for (std::size_t g = 0; g < s.images; ++g) {
    GrainRecord<D>& d = s.record[s.count + g];
    d = s.record[s.ghost[g].source];
    d.place += s.domain.way(s.ghost[g].shift);
    d.velocity += image_velocity(s, s.ghost[g].shift);
  }
  each_part(s, [&](auto& part) { part.refresh(s); });
}

template <int D> void list_contacts(SampleIn<D>& s, const ThreadPool& pool) {
  ContactListIn<D>& list = s.list;
  each_part(s, [&](auto& part) { part.number(s); });
  make_ghosts(s);
  list_pairs(s, pool);
  each_part(s, [&](auto& part) { part.list_pairs(s, pool); });
  list_walls(s);
  list.polygons = list.size();
  each_part(s, [&](auto& part) { part.list_others(s); });
  std::size_t others = 0;
  each_part(s, [&](auto& part) {
    part.first_force = others;
    others += part.force_count();
  });
  group_slots(s);
  list.force.assign(place_of_force(list, others), SlotForce<D>{});
  list.memory.assign(list.size());
  if (s.contact.normal.visit([](const auto& law) { return law.remembers; })) list.normal_memory.assign(list.size());
  list.rolling_memory.assign(s.contact.rolls_freely() ? 0 : list.size());
  list.twist_memory.assign(resists_twisting(s) ? list.size() : 0);
  list.glue.assign(list.size(), never_touched);
}

template void refresh_ghosts(SampleIn<2>&);
template void refresh_ghosts(SampleIn<3>&);
template void list_contacts(SampleIn<2>&, const ThreadPool&);
template void list_contacts(SampleIn<3>&, const ThreadPool&);

}  // namespace arenite::dem
