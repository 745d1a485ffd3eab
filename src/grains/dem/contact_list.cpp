#include <algorithm>

#include "core/mapped.hpp"
#include "geometry/cell_grid.hpp"
#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/bonds.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {
namespace {

/// Makes the images of the disks near the right and the upper edge of a periodic cell, with records behind those of the
/// disks: every pair across an edge then occurs once, as (disk, ghost).
template <int D> void make_ghosts(SampleIn<D>& s) {
  s.ghost.clear();
  if constexpr (D == 2) {
    s.foot.clear();
    s.point_foot.clear();
  }
  s.record.resize(s.count);
  const double reach = reach_of(s);
  bool after = false;  // the cell of now
  s.domain.each_near_cell([&](Cells<D> cell) {
    for (std::size_t k = 0; after && k < s.count; ++k)
      if (s.domain.is_near(s.record[k].place + s.domain.way(cell), reach))
        s.ghost.push_back({static_cast<std::int32_t>(k), cell});
    after = after || cell == Cells<D>{};
  });
  s.record.resize(s.count + s.ghost.size());
  refresh_ghosts(s);
}

/// Whether the list must have a pair.
template <int D> bool are_near(const SampleIn<D>& s, const GrainRecord<D>& a, const GrainRecord<D>& b) {
  const Vec<D> d = a.place - b.place;
  const double reach = a.radius + b.radius + s.skin + s.cohesion.reach;
  return dot(d, d) < reach * reach;
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
      if (are_near(s, a, s.record[j])) near.push_back({k, j});
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
    if constexpr (D == 2)
      if (!s.part.empty())
        near.erase(std::remove_if(near.begin() + before, near.end(),
                                  [&](const NearPair& pair) { return !disks_meet(s, pair.i, pair.j); }),
                   near.end());
  });
}

template <int D>
void fill_slot(ContactListIn<D>& list, std::size_t p, std::int32_t i, std::int32_t j, std::int32_t owner,
               const Coefficients& c) {
  list.i[p] = i;
  list.j[p] = j;
  list.owner[p] = owner;
  list.stiffness[p] = c.stiffness;
  list.damping[p] = c.damping;
  list.viscosity[p] = c.viscosity;
  list.strength[p] = c.strength;
  list.shear[p] = c.shear;
}

template <int D>
void add_slot(ContactListIn<D>& list, std::int32_t i, std::int32_t j, std::int32_t owner, const Coefficients& c) {
  list.resize(list.size() + 1);
  fill_slot(list, list.size() - 1, i, j, owner, c);
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

/// Slots of disks that may touch polygons, behind those of pairs of disks.
void list_feet(Sample& s, const ThreadPool& pool) {
  s.foot = find_feet(s, pool);
  ContactList& list = s.list;
  const std::size_t ghosts = s.ghost.size();
  for (const Foot& foot : s.foot) {
    const std::int32_t owner = s.part_disk[s.body[foot.body].first];
    s.ghost.push_back({owner, foot.shift});
    add_slot(list, foot.touches, static_cast<std::int32_t>(s.count + s.ghost.size() - 1), owner,
             pair_coefficients(s, s.record[foot.touches], s.record[owner]));
  }
  list.pairs += s.ghost.size() - ghosts;
  s.record.resize(s.count + s.ghost.size());
  refresh_feet(s);
}

/// Slots of walls and boundaries.
template <int D> void list_walls(SampleIn<D>& s) {
  std::vector<geometry::Rectangle> boxes;
  if constexpr (D == 2)
    boxes = mapped(s.domain.boundaries, [](const Boundary& boundary) { return geometry::bounds(boundary.points); });
  std::vector<std::int32_t> near;
  for (std::size_t k = 0; k < s.count; ++k) {
    const GrainRecord<D>& d = s.record[k];
    const HeldGrain* held = find_held(s, d.grain);
    const auto add = [&](std::int32_t j) {
      add_slot(s.list, static_cast<std::int32_t>(k), j, -1, s.coefficients.wall(d));
    };
    for (int side = 0; side < sides_in<D>; ++side) {
      const bool may_touch = s.domain.wall[side].present && !(held && held->side == side);
      if (may_touch && s.domain.depth(side, d.place) < d.radius + s.skin) add(wall_partner(side));
    }
    if constexpr (D == 2) find_near_elements(s, boxes, d, near);
    for (const std::int32_t e : near) add(boundary_partner(e));
  }
}

/// Slots of polygons that may touch points of boundaries, behind all others.
void list_point_feet(Sample& s) {
  ContactList& list = s.list;
  s.point_foot = find_point_feet(s);
  for (const Foot& foot : s.point_foot) {
    const std::int32_t first = s.part_disk[s.body[foot.body].first];
    add_slot(list, first, foot.touches, -1, s.coefficients.wall(s.record[first]));
  }
  s.record.resize(s.count + s.ghost.size() + s.point_foot.size());
  refresh_feet(s);
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
    if constexpr (D == 2)
      for (std::size_t b = 0; b < s.bond_slots.size(); ++b) {
        see(2 * s.bond_slots[b].i, bond_force_place(list, b));
        see(2 * s.bond_slots[b].j + 1, bond_force_place(list, b));
      }
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
  std::size_t images = s.ghost.size();
  if constexpr (D == 2) images -= s.foot.size();
  for (std::size_t g = 0; g < images; ++g) {
    GrainRecord<D>& d = s.record[s.count + g];
    d = s.record[s.ghost[g].source];
    d.place += s.domain.way(s.ghost[g].shift);
    d.velocity += image_velocity(s, s.ghost[g].shift);
  }
  if constexpr (D == 2) refresh_feet(s);
}

template <int D> void list_contacts(SampleIn<D>& s, const ThreadPool& pool) {
  ContactListIn<D>& list = s.list;
  std::size_t bonds = 0;
  if constexpr (D == 2) number_parts(s);
  make_ghosts(s);
  list_pairs(s, pool);
  if constexpr (D == 2)
    if (!s.body.empty()) list_feet(s, pool);
  list_walls(s);
  list.polygons = list.size();
  if constexpr (D == 2) {
    list_point_feet(s);
    list_bonds(s);
    bonds = s.bond_slots.size();
  }
  group_slots(s);
  list.force.assign(bond_force_place(list, bonds), SlotForce<D>{});
  list.memory.assign(list.size());
  if (s.contact.normal.visit([](const auto& law) { return law.remembers; })) list.normal_memory.assign(list.size());
  list.rolling_memory.assign(s.contact.rolls_freely() ? 0 : list.size());
  list.pull.assign(s.contact.is_cohesive() ? list.pairs : 0);
  list.curve.assign(list.pull.size(), 0);
  list.bond.assign(list.size(), never_touched);
}

template void refresh_ghosts(SampleIn<2>&);
template void refresh_ghosts(SampleIn<3>&);
template void list_contacts(SampleIn<2>&, const ThreadPool&);
template void list_contacts(SampleIn<3>&, const ThreadPool&);

}  // namespace arenite::dem
