#include <algorithm>

#include "geometry/cell_grid.hpp"
#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/bonds.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {
namespace {

/// Partners of disk k that come after it: disks are sorted by cell, so they are the rest of its cell and the next one, and three cells of the row
/// above.
void find_near_disks(const Sample& s, const geometry::CellGrid& grid, const geometry::SortedCells& cells, std::size_t k, std::vector<std::int32_t>& near) {
  const auto& a = s.record[k];
  const std::int32_t row = grid.row(a.y), column = grid.column(a.x);
  const std::int32_t from = std::max(column - 1, 0), to = std::min(column + 1, grid.columns - 1);
  const auto look_at = [&](std::int32_t begin, std::int32_t end) {
    for (std::int32_t j = begin; j < end; ++j) {
      const auto& b = s.record[static_cast<std::size_t>(j)];
      const double dx = a.x - b.x, dy = a.y - b.y, reach = a.radius + b.radius + s.skin + s.cohesion.reach;
      if (dx * dx + dy * dy < reach * reach) near.push_back(j);
    }
  };
  const auto first_of = [&](std::int32_t r, std::int32_t c) {
    return cells.first[static_cast<std::size_t>(r) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(c)];
  };
  look_at(static_cast<std::int32_t>(k) + 1, first_of(row, to + 1));
  if (row + 1 < grid.rows) look_at(first_of(row + 1, from), first_of(row + 1, to + 1));
}

/// Ghosts near disk k, in any cell around its own.
void find_near_ghosts(const Sample& s, const geometry::CellGrid& grid, const geometry::SortedCells& ghosts, std::size_t k, std::vector<std::int32_t>& near) {
  const auto& a = s.record[k];
  const std::int32_t row = grid.row(a.y), column = grid.column(a.x);
  const auto begin = static_cast<std::ptrdiff_t>(near.size());
  for (std::int32_t r = std::max(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r)
    for (std::int32_t c = std::max(column - 1, 0); c <= std::min(column + 1, grid.columns - 1); ++c) {
      const auto cell = static_cast<std::size_t>(r * grid.columns + c);
      for (std::int32_t q = ghosts.first[cell]; q < ghosts.first[cell + 1]; ++q) {
        const std::int32_t j = ghosts.item[static_cast<std::size_t>(q)];
        const auto& b = s.record[static_cast<std::size_t>(j)];
        const double dx = a.x - b.x, dy = a.y - b.y, reach = a.radius + b.radius + s.skin + s.cohesion.reach;
        if (dx * dx + dy * dy < reach * reach) near.push_back(j);
      }
    }
  std::sort(near.begin() + begin, near.end());
}

/// Partners of consecutive disks, and how many each has.
struct Found {
  std::vector<std::int32_t> partner, count;
};
constexpr std::size_t disks_of_block = 64;

/// The partners of all disks, block by block: what a block finds does not depend on who searches it.
std::vector<Found> find_partners(const Sample& s, const Team& team) {
  const geometry::CellGrid grid = cells_of(s);
  const std::size_t n = s.count;
  const auto cell_of = [&](std::size_t k) { return grid.cell(s.record[k].x, s.record[k].y); };
  const geometry::SortedCells inner(grid, 0, n, cell_of), images(grid, n, s.record.size(), cell_of);
  // Ghosts lie beyond the right and the upper edge.
  const double reach = reach_of(s), right_zone = s.domain.wall[right].position - reach, upper_zone = s.domain.wall[top].position - reach;
  std::vector<Found> blocks((n + disks_of_block - 1) / disks_of_block);
  team.for_ranges(blocks.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      auto& [partner, count] = blocks[block];
      for (std::size_t k = block * disks_of_block; k < std::min(n, (block + 1) * disks_of_block); ++k) {
        const std::size_t before = partner.size();
        const auto& a = s.record[k];
        find_near_disks(s, grid, inner, k, partner);
        if (!s.ghost.empty() && (a.x > right_zone || a.y > upper_zone)) find_near_ghosts(s, grid, images, k, partner);
        if (!s.part.empty()) drop_own_disks(s, k, partner, before);
        count.push_back(static_cast<std::int32_t>(partner.size() - before));
      }
    }
  });
  return blocks;
}

void fill_slot(ContactList& list, std::size_t p, std::size_t i, std::int32_t j, std::int32_t owner, const Coefficients& c) {
  list.i[p] = static_cast<std::int32_t>(i);
  list.j[p] = j;
  list.owner[p] = owner;
  list.stiffness[p] = c.stiffness;
  list.damping[p] = c.damping;
  list.viscosity[p] = c.viscosity;
  list.strength[p] = c.strength;
  list.shear[p] = c.shear;
}

void fill_block(Sample& s, std::size_t block, const Found& found, std::size_t slot) {
  const auto n = static_cast<std::int32_t>(s.count);
  std::size_t k = block * disks_of_block, next = 0;
  for (const std::int32_t count : found.count) {
    const auto& a = s.record[k];
    for (std::int32_t q = 0; q < count; ++q, ++slot) {
      const std::int32_t j = found.partner[next++];
      const auto& b = s.record[static_cast<std::size_t>(j)];
      const std::int32_t owner = j < n ? j : s.ghost[static_cast<std::size_t>(j - n)].source;
      fill_slot(s.list, slot, k, j, owner, s.coefficients.pair(a.material, b.material, a.mass, b.mass, a.radius, b.radius, is_glued(s, a.grain, b.grain)));
    }
    ++k;
  }
}

void list_pairs(Sample& s, const Team& team) {
  const std::vector<Found> blocks = find_partners(s, team);
  std::vector<std::size_t> first{0};
  for (const Found& found : blocks) first.push_back(first.back() + found.partner.size());
  s.list.pairs = first.back();
  s.list.resize(first.back());
  team.for_ranges(blocks.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) fill_block(s, block, blocks[block], first[block]);
  });
}

/// Slots of disks that may touch polygons, behind those of pairs of disks.
void list_feet(Sample& s, const Team& team) {
  s.foot = find_feet(s, team);
  ContactList& list = s.list;
  const std::size_t ghosts = s.ghost.size();
  for (const Foot& foot : s.foot) {
    const auto owner = s.part_disk[static_cast<std::size_t>(s.body[static_cast<std::size_t>(foot.body)].first)];
    const auto &a = s.record[static_cast<std::size_t>(foot.touches)], &b = s.record[static_cast<std::size_t>(owner)];
    s.ghost.push_back({owner, foot.shift_x, foot.shift_y});
    list.resize(list.size() + 1);
    fill_slot(list, list.size() - 1, static_cast<std::size_t>(foot.touches), static_cast<std::int32_t>(s.count + s.ghost.size() - 1), owner,
              s.coefficients.pair(a.material, b.material, a.mass, b.mass, a.radius, b.radius, false));
  }
  list.pairs += s.ghost.size() - ghosts;
  s.record.resize(s.count + s.ghost.size());
  refresh_feet(s);
}

/// Slots of walls and boundaries.
void list_walls(Sample& s) {
  ContactList& list = s.list;
  const NearElements elements(s);
  std::vector<std::int32_t> near;
  const auto add = [&](std::size_t k, std::int32_t j) {
    const auto& d = s.record[k];
    list.resize(list.size() + 1);
    fill_slot(list, list.size() - 1, k, j, -1, s.coefficients.wall(d.material, d.mass, d.radius));
  };
  for (std::size_t k = 0; k < s.count; ++k) {
    const auto& d = s.record[k];
    const HeldGrain* held = find_held(s, d.grain);
    for (int side = 0; side < 4; ++side) {
      const auto& wall = s.domain.wall[static_cast<std::size_t>(side)];
      if (!wall.present || (held && held->side == side)) continue;
      const double place = side < bottom ? d.x : d.y;
      const double distance = (side % 2 == 0) ? place - wall.position : wall.position - place;
      if (distance < d.radius + s.skin) add(k, wall_partner(side));
    }
    elements.find(d, near);
    for (const std::int32_t e : near) add(k, boundary_partner(e));
  }
}

/// Slots of polygons that may touch points of boundaries, behind all others.
void list_point_feet(Sample& s) {
  ContactList& list = s.list;
  list.polygons = list.size();
  s.point_foot = find_point_feet(s);
  for (const Foot& foot : s.point_foot) {
    const auto first = static_cast<std::size_t>(s.part_disk[static_cast<std::size_t>(s.body[static_cast<std::size_t>(foot.body)].first)]);
    const DiskRecord& d = s.record[first];
    list.resize(list.size() + 1);
    fill_slot(list, list.size() - 1, first, foot.touches, -1, s.coefficients.wall(d.material, d.mass, d.radius));
  }
  s.record.resize(s.count + s.ghost.size() + s.point_foot.size());
  refresh_feet(s);
}

/// Fills list.group and list.first, see there.
void group_slots(Sample& s) {
  ContactList& list = s.list;
  const auto none = static_cast<std::int32_t>(list.size());
  const auto groups = [](std::int32_t slots) { return 4 * std::max((slots + 3) / 4, 1); };
  std::vector<std::int32_t> used(2 * s.count + 1, 0);
  for (std::size_t p = 0; p < list.size(); ++p) {
    ++used[2 * static_cast<std::size_t>(list.i[p])];
    if (list.owner[p] >= 0) ++used[2 * static_cast<std::size_t>(list.owner[p]) + 1];
  }
  for (const BondSlot& bond : s.bond_slots) {
    ++used[2 * static_cast<std::size_t>(bond.i)];
    ++used[2 * static_cast<std::size_t>(bond.j) + 1];
  }
  list.first.assign(2 * s.count + 1, 0);
  for (std::size_t q = 0; q < 2 * s.count; ++q) list.first[q + 1] = list.first[q] + groups(used[q]);
  list.group.assign(static_cast<std::size_t>(list.first.back()), none);
  std::vector<std::int32_t> next = list.first;
  const auto put = [&](std::size_t q, std::size_t p) { list.group[static_cast<std::size_t>(next[q]++)] = static_cast<std::int32_t>(p); };
  for (std::size_t p = 0; p < list.size(); ++p) {
    put(2 * static_cast<std::size_t>(list.i[p]), p);
    if (list.owner[p] >= 0) put(2 * static_cast<std::size_t>(list.owner[p]) + 1, p);
  }
  for (std::size_t b = 0; b < s.bond_slots.size(); ++b) {
    put(2 * static_cast<std::size_t>(s.bond_slots[b].i), bond_force_place(list, b));
    put(2 * static_cast<std::size_t>(s.bond_slots[b].j) + 1, bond_force_place(list, b));
  }
}

}  // namespace

void list_contacts(Sample& s, const Team& team) {
  number_parts(s);
  make_ghosts(s);
  list_pairs(s, team);
  if (!s.body.empty()) list_feet(s, team);
  list_walls(s);
  list_point_feet(s);
  list_bonds(s);
  group_slots(s);
  s.list.force.assign(bond_force_place(s.list, s.bond_slots.size()), SlotForce{});
  s.list.memory.assign(s.list.size(), 0.0);
  if (std::visit([](const auto& law) { return law.remembers; }, s.contact.normal)) s.list.normal_memory.assign(s.list.size(), 0.0);
  const bool rolls = !std::holds_alternative<NoRolling>(s.contact.rolling);
  s.list.rolling_memory.assign(rolls ? s.list.size() : 0, 0.0);
  s.list.pull.assign(s.contact.is_cohesive() ? s.list.pairs : 0, 0.0);
  s.list.curve.assign(s.list.pull.size(), 0);
  s.list.bond.assign(s.list.size(), never_touched);
}

}  // namespace arenite::dem
