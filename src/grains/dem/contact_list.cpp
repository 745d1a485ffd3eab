#include <algorithm>

#include "core/mapped.hpp"
#include "geometry/cell_grid.hpp"
#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/bonds.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {
namespace {

/// Makes the images of the disks near the right and the upper edge of a periodic cell, with records behind those of the disks: every pair across an edge
/// then occurs once, as (disk, ghost).
void make_ghosts(Sample& s) {
  s.ghost.clear();
  s.foot.clear();
  s.point_foot.clear();
  s.record.resize(s.count);
  const double reach = reach_of(s);
  bool after = false;  // the cell of now
  s.domain.each_near_cell([&](Cells<2> cell) {
    for (std::size_t k = 0; after && k < s.count; ++k)
      if (s.domain.is_near(s.record[k].place + s.domain.way(cell), reach)) s.ghost.push_back({static_cast<std::int32_t>(k), cell});
    after = after || cell == Cells<2>{};
  });
  s.record.resize(s.count + s.ghost.size());
  refresh_ghosts(s);
}

/// Whether the list must have a pair.
bool are_near(const Sample& s, const DiskRecord& a, const DiskRecord& b) {
  const Vec2 d = a.place - b.place;
  const double reach = a.radius + b.radius + s.skin + s.cohesion.reach;
  return dot(d, d) < reach * reach;
}

/// A disk and its partner, which comes after it or is a ghost.
struct NearPair {
  std::int32_t i, j;
};

/// Partners of disk k that come after it: disks are sorted by cell, so they are the rest of its cell and the next one, and three cells of the row
/// above.
void find_near_disks(const Sample& s, const geometry::CellGrid<2>& grid, const geometry::SortedCells& cells, std::int32_t k, std::vector<NearPair>& near) {
  const DiskRecord& a = s.record[k];
  const std::int32_t row = grid.along(1, a.place.y), column = grid.along(0, a.place.x);
  const std::int32_t from = std::max(column - 1, 0), to = std::min(column + 1, grid.count[0] - 1);
  const auto look_at = [&](std::int32_t begin, std::int32_t end) {
    for (std::int32_t j = begin; j < end; ++j)
      if (are_near(s, a, s.record[j])) near.push_back({k, j});
  };
  const auto first_of = [&](std::int32_t r, std::int32_t c) { return cells.first[r * grid.count[0] + c]; };
  look_at(k + 1, first_of(row, to + 1));
  if (row + 1 < grid.count[1]) look_at(first_of(row + 1, from), first_of(row + 1, to + 1));
}

/// Ghosts near disk k, in any cell around its own.
void find_near_ghosts(const Sample& s, const geometry::CellGrid<2>& grid, const geometry::SortedCells& ghosts, std::int32_t k, std::vector<NearPair>& near) {
  const DiskRecord& a = s.record[k];
  const auto begin = static_cast<std::ptrdiff_t>(near.size());
  ghosts.for_near(grid, a.place, [&](std::int32_t j) {
    if (are_near(s, a, s.record[j])) near.push_back({k, j});
  });
  std::ranges::sort(near.begin() + begin, near.end(), {}, &NearPair::j);
}

/// All pairs, block by block: what a block finds does not depend on who searches it.
std::vector<std::vector<NearPair>> find_pairs(const Sample& s, const ThreadPool& pool) {
  const auto grid = cells_of(s);
  const std::size_t n = s.count;
  const auto cell_of = [&](std::size_t k) { return grid.cell(s.record[k].place); };
  const geometry::SortedCells inner(grid.size(), 0, n, cell_of), images(grid.size(), n, s.record.size(), cell_of);
  // Ghosts lie beyond the right and the upper edge.
  const double reach = reach_of(s), right_zone = s.domain.wall[right].position - reach, upper_zone = s.domain.wall[top].position - reach;
  return pool.by_blocks<std::vector<NearPair>>(n, disks_of_block, [&](std::size_t disk, std::vector<NearPair>& near) {
    const auto k = static_cast<std::int32_t>(disk);
    const Vec2 place = s.record[k].place;
    const std::size_t before = near.size();
    find_near_disks(s, grid, inner, k, near);
    if (!s.ghost.empty() && (place.x > right_zone || place.y > upper_zone)) find_near_ghosts(s, grid, images, k, near);
    if (s.part.empty()) return;
    const auto is_own = [&](const NearPair& pair) { return !disks_meet(s, pair.i, pair.j); };
    near.erase(std::remove_if(near.begin() + static_cast<std::ptrdiff_t>(before), near.end(), is_own), near.end());
  });
}

void fill_slot(ContactList& list, std::size_t p, std::int32_t i, std::int32_t j, std::int32_t owner, const Coefficients& c) {
  list.i[p] = i;
  list.j[p] = j;
  list.owner[p] = owner;
  list.stiffness[p] = c.stiffness;
  list.damping[p] = c.damping;
  list.viscosity[p] = c.viscosity;
  list.strength[p] = c.strength;
  list.shear[p] = c.shear;
}

void add_slot(ContactList& list, std::int32_t i, std::int32_t j, std::int32_t owner, const Coefficients& c) {
  list.resize(list.size() + 1);
  fill_slot(list, list.size() - 1, i, j, owner, c);
}

void list_pairs(Sample& s, const ThreadPool& pool) {
  const std::vector<std::vector<NearPair>> blocks = find_pairs(s, pool);
  std::vector<std::size_t> first{0};
  for (const auto& block : blocks) first.push_back(first.back() + block.size());
  s.list.pairs = first.back();
  s.list.resize(first.back());
  const auto n = static_cast<std::int32_t>(s.count);
  pool.for_ranges(blocks.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin, slot = first[begin]; block < end; ++block)
      for (const auto& [i, j] : blocks[block])
        fill_slot(s.list, slot++, i, j, j < n ? j : s.ghost[j - n].source, pair_coefficients(s, s.record[i], s.record[j]));
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
    add_slot(list, foot.touches, static_cast<std::int32_t>(s.count + s.ghost.size() - 1), owner, pair_coefficients(s, s.record[foot.touches], s.record[owner]));
  }
  list.pairs += s.ghost.size() - ghosts;
  s.record.resize(s.count + s.ghost.size());
  refresh_feet(s);
}

/// Slots of walls and boundaries.
void list_walls(Sample& s) {
  const auto boxes = mapped(s.domain.boundaries, [](const Boundary& boundary) { return geometry::bounds(boundary.points); });
  std::vector<std::int32_t> near;
  for (std::size_t k = 0; k < s.count; ++k) {
    const DiskRecord& d = s.record[k];
    const HeldGrain* held = find_held(s, d.grain);
    const auto add = [&](std::int32_t j) { add_slot(s.list, static_cast<std::int32_t>(k), j, -1, s.coefficients.wall(d)); };
    for (int side = 0; side < sides; ++side) {
      const bool may_touch = s.domain.wall[side].present && !(held && held->side == side);
      if (may_touch && s.domain.depth(side, d.place) < d.radius + s.skin) add(wall_partner(side));
    }
    find_near_elements(s, boxes, d, near);
    for (const std::int32_t e : near) add(boundary_partner(e));
  }
}

/// Slots of polygons that may touch points of boundaries, behind all others.
void list_point_feet(Sample& s) {
  ContactList& list = s.list;
  list.polygons = list.size();
  s.point_foot = find_point_feet(s);
  for (const Foot& foot : s.point_foot) {
    const std::int32_t first = s.part_disk[s.body[foot.body].first];
    add_slot(list, first, foot.touches, -1, s.coefficients.wall(s.record[first]));
  }
  s.record.resize(s.count + s.ghost.size() + s.point_foot.size());
  refresh_feet(s);
}

/// Fills list.group and list.first, see there.
void group_slots(Sample& s) {
  ContactList& list = s.list;
  const auto none = static_cast<std::int32_t>(list.size());
  const auto groups = [](std::int32_t slots) { return 4 * std::max((slots + 3) / 4, 1); };
  const auto each = [&](const auto& see) {  // (place of its disk in list.first, slot)
    for (std::size_t p = 0; p < list.size(); ++p) {
      see(2 * list.i[p], p);
      if (list.owner[p] >= 0) see(2 * list.owner[p] + 1, p);
    }
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

void refresh_ghosts(Sample& s) {
  for (std::size_t g = 0; g < s.ghost.size() - s.foot.size(); ++g) {
    DiskRecord& d = s.record[s.count + g];
    d = s.record[s.ghost[g].source];
    d.place += s.domain.way(s.ghost[g].shift);
    d.velocity += image_velocity(s, s.ghost[g].shift);
  }
  refresh_feet(s);
}

void list_contacts(Sample& s, const ThreadPool& pool) {
  number_parts(s);
  make_ghosts(s);
  list_pairs(s, pool);
  if (!s.body.empty()) list_feet(s, pool);
  list_walls(s);
  list_point_feet(s);
  list_bonds(s);
  group_slots(s);
  s.list.force.assign(bond_force_place(s.list, s.bond_slots.size()), SlotForce<2>{});
  s.list.memory.assign(s.list.size(), 0.0);
  if (s.contact.normal.visit([](const auto& law) { return law.remembers; })) s.list.normal_memory.assign(s.list.size(), 0.0);
  s.list.rolling_memory.assign(s.contact.rolls_freely() ? 0 : s.list.size(), 0.0);
  s.list.pull.assign(s.contact.is_cohesive() ? s.list.pairs : 0, 0.0);
  s.list.curve.assign(s.list.pull.size(), 0);
  s.list.bond.assign(s.list.size(), never_touched);
}

}  // namespace arenite::dem
