#include "dem/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace arenite::dem {

AffineMotion affine_x(const Domain& domain) {
  if (!domain.periodic_x) return {};
  const auto& a = domain.wall[left];
  const auto& b = domain.wall[right];
  return {a.position, a.velocity, (b.velocity - a.velocity) / (b.position - a.position)};
}

AffineMotion affine_y(const Domain& domain) {
  if (!domain.periodic_y) return {};
  const auto& a = domain.wall[bottom];
  const auto& b = domain.wall[top];
  return {a.position, a.velocity, (b.velocity - a.velocity) / (b.position - a.position)};
}

namespace {

/// Cells of at least `size`, row by row, over a rectangle; points outside belong to the border cells.
struct CellGrid {
  double x0, y0, inverse_x, inverse_y;
  std::int32_t columns, rows;

  CellGrid(double left, double bottom, double right, double top, double size)
      : x0(left), y0(bottom) {
    columns = std::clamp(static_cast<std::int32_t>((right - left) / size), 1, 4096);
    rows = std::clamp(static_cast<std::int32_t>((top - bottom) / size), 1, 4096);
    inverse_x = columns / (right - left);
    inverse_y = rows / (top - bottom);
  }
  std::int32_t column(double x) const {
    return static_cast<std::int32_t>(std::clamp((x - x0) * inverse_x, 0.0, columns - 1.0));
  }
  std::int32_t row(double y) const {
    return static_cast<std::int32_t>(std::clamp((y - y0) * inverse_y, 0.0, rows - 1.0));
  }
  std::int32_t cell(double x, double y) const { return row(y) * columns + column(x); }
  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

CellGrid grid_of(const Sample& s) {
  const auto& w = s.domain.wall;
  const double cell = reach_of(s);
  return {w[left].position, w[bottom].position, w[right].position, w[top].position, cell};
}

void check_places(const Sample& s) {
  for (std::size_t k = 0; k < s.count; ++k) {
    const auto& d = s.record[k];
    const char* fault = nullptr;
    if (!std::isfinite(d.x + d.y + d.vx + d.vy + d.omega)) fault = " has a coordinate or velocity that is not finite";
    for (int side = 0; side < 4 && !fault; ++side) {
      const auto& wall = s.domain.wall[static_cast<std::size_t>(side)];
      const double place = side < bottom ? d.x : d.y;
      const double inside = (side % 2 == 0) ? place - wall.position : wall.position - place;
      if (wall.present && inside < 0) fault = " has left the frame through a wall";
    }
    if (fault) {
      const auto id = s.start.grains.id[static_cast<std::size_t>(d.grain)];
      throw std::runtime_error("grain " + std::to_string(id) + fault + " at step " + std::to_string(s.step) +
                               "; a smaller time step or a gentler load is needed");
    }
  }
}

/// A grain that crosses a periodic edge goes on at the opposite one; its own velocity is without the affine motion and
/// does not change, the seen velocity is renewed by the caller's next refresh.
void wrap(Sample& s) {
  const auto& w = s.domain.wall;
  const double width = s.domain.width(), height = s.domain.height();
  const AffineMotion mx = affine_x(s.domain), my = affine_y(s.domain);
  for (std::size_t k = 0; k < s.count; ++k) {
    auto& d = s.record[k];
    if (s.domain.periodic_y) {
      const double n = std::floor((d.y - w[bottom].position) / height);
      const double y = d.y - n * height;
      d.vy += my.at(y) - my.at(d.y);
      d.y = y;
      d.x -= n * s.domain.tilt;
    }
    if (s.domain.periodic_x) {
      const double x = d.x - std::floor((d.x - w[left].position) / width) * width;
      d.vx += mx.at(x) - mx.at(d.x);
      d.x = x;
    }
  }
}

template <class T>
void permute(std::vector<T>& values, const std::vector<std::int32_t>& order) {
  if (values.empty()) return;
  std::vector<T> old(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(order.size()));
  for (std::size_t k = 0; k < order.size(); ++k) values[k] = old[static_cast<std::size_t>(order[k])];
}

void sort_by_cell(Sample& s) {
  const CellGrid grid = grid_of(s);
  std::vector<std::int32_t> first(grid.size() + 1, 0), cell(s.count), order(s.count);
  for (std::size_t k = 0; k < s.count; ++k) {
    cell[k] = grid.cell(s.record[k].x, s.record[k].y);
    ++first[static_cast<std::size_t>(cell[k]) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  for (std::size_t k = 0; k < s.count; ++k)
    order[static_cast<std::size_t>(first[static_cast<std::size_t>(cell[k])]++)] = static_cast<std::int32_t>(k);
  s.record.resize(s.count);
  permute(s.record, order);
  for (auto* a : {&s.vx, &s.vy, &s.omega, &s.angle, &s.ax, &s.ay, &s.alpha}) permute(*a, order);
  for (auto& a : s.higher) permute(a, order);
}

/// Images to the right and above only: every pair across an edge then occurs once, as (disk, ghost).
void make_ghosts(Sample& s) {
  s.ghost.clear();
  s.record.resize(s.count);
  const double reach = reach_of(s);
  const auto& w = s.domain.wall;
  const double width = s.domain.width(), height = s.domain.height();
  const int up = s.domain.periodic_y ? 1 : 0, across = s.domain.periodic_x ? 1 : 0;
  for (int iy = 0; iy <= up; ++iy)
    for (int ix = iy == 0 ? 1 : -across; ix <= across; ++ix)
      for (std::size_t k = 0; k < s.count; ++k) {
        const double x = s.record[k].x + ix * width + iy * s.domain.tilt, y = s.record[k].y + iy * height;
        const bool near_x = !s.domain.periodic_x ||
                            (x > w[left].position - reach && x < w[right].position + reach);
        if (near_x && y < w[top].position + reach) s.ghost.push_back({static_cast<std::int32_t>(k), ix, iy});
      }
  s.record.resize(s.count + s.ghost.size());
  refresh_ghosts(s);
}

/// Disks sorted into cells: those of cell c are item[first[c]] .. item[first[c + 1] - 1].
struct Cells {
  std::vector<std::int32_t> first, item;
  Cells(const CellGrid& grid, const std::vector<DiskRecord>& record, std::size_t begin, std::size_t end)
      : first(grid.size() + 1, 0), item(end - begin) {
    for (std::size_t k = begin; k < end; ++k) ++first[static_cast<std::size_t>(grid.cell(record[k].x, record[k].y)) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::int32_t> next = first;
    for (std::size_t k = begin; k < end; ++k)
      item[static_cast<std::size_t>(next[static_cast<std::size_t>(grid.cell(record[k].x, record[k].y))]++)] =
          static_cast<std::int32_t>(k);
  }
};

void add_slot(ContactList& list, std::int32_t i, std::int32_t j, std::int32_t owner, const Coefficients& c) {
  list.i.push_back(i);
  list.j.push_back(j);
  list.owner.push_back(owner);
  list.stiffness.push_back(c.stiffness);
  list.damping.push_back(c.damping);
  list.viscosity.push_back(c.viscosity);
  list.strength.push_back(c.strength);
}

/// The pair was declared glued: by name, or by its zones where no pair is named.
bool is_named(const Sample& s, std::int32_t a, std::int32_t b) {
  const auto& zone = s.start.grains.zone;
  const auto& glued = s.contact.glued_pairs;  // sorted, low index first
  if (glued.empty()) return zone[static_cast<std::size_t>(a)] > 0 && zone[static_cast<std::size_t>(b)] > 0;
  return std::binary_search(glued.begin(), glued.end(), std::pair{std::min(a, b), std::max(a, b)});
}

bool is_glued(const Sample& s, std::int32_t a, std::int32_t b) {
  if (!s.glue) return false;
  switch (s.contact.adhesion) {
    case Adhesion::none: return false;
    case Adhesion::geometrical: return is_named(s, a, b);
    case Adhesion::geometrical_breaking:
      return std::binary_search(s.live_bonds.begin(), s.live_bonds.end(), pair_key(a, b));
  }
  return false;
}

/// Partners of disk k that come after it: disks are sorted by cell, so they are the rest of its cell and the next one,
/// and three cells of the row above.
void find_near_disks(const Sample& s, const CellGrid& grid, const Cells& cells, std::size_t k,
                     std::vector<std::int32_t>& near) {
  const auto& a = s.record[k];
  const std::int32_t row = grid.row(a.y), column = grid.column(a.x);
  const std::int32_t from = std::max(column - 1, 0), to = std::min(column + 1, grid.columns - 1);
  const auto look_at = [&](std::int32_t begin, std::int32_t end) {
    for (std::int32_t j = begin; j < end; ++j) {
      const auto& b = s.record[static_cast<std::size_t>(j)];
      const double dx = a.x - b.x, dy = a.y - b.y, reach = a.radius + b.radius + s.skin;
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
void find_near_ghosts(const Sample& s, const CellGrid& grid, const Cells& ghosts, std::size_t k,
                      std::vector<std::int32_t>& near) {
  const auto& a = s.record[k];
  const std::int32_t row = grid.row(a.y), column = grid.column(a.x);
  const auto begin = static_cast<std::ptrdiff_t>(near.size());
  for (std::int32_t r = std::max(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r)
    for (std::int32_t c = std::max(column - 1, 0); c <= std::min(column + 1, grid.columns - 1); ++c) {
      const auto cell = static_cast<std::size_t>(r * grid.columns + c);
      for (std::int32_t q = ghosts.first[cell]; q < ghosts.first[cell + 1]; ++q) {
        const std::int32_t j = ghosts.item[static_cast<std::size_t>(q)];
        const auto& b = s.record[static_cast<std::size_t>(j)];
        const double dx = a.x - b.x, dy = a.y - b.y, reach = a.radius + b.radius + s.skin;
        if (dx * dx + dy * dy < reach * reach) near.push_back(j);
      }
    }
  std::sort(near.begin() + begin, near.end());
}

void list_pairs(Sample& s) {
  const CellGrid grid = grid_of(s);
  const std::size_t n = s.count;
  const Cells inner(grid, s.record, 0, n), images(grid, s.record, n, s.record.size());
  // Ghosts lie beyond the right and the upper edge.
  const double reach = reach_of(s), right_zone = s.domain.wall[right].position - reach,
               upper_zone = s.domain.wall[top].position - reach;
  std::vector<std::int32_t> near;
  for (std::size_t k = 0; k < n; ++k) {
    const auto& a = s.record[k];
    near.clear();
    find_near_disks(s, grid, inner, k, near);
    if (!s.ghost.empty() && (a.x > right_zone || a.y > upper_zone)) find_near_ghosts(s, grid, images, k, near);
    for (const std::int32_t j : near) {
      const auto& b = s.record[static_cast<std::size_t>(j)];
      const std::int32_t owner = j < static_cast<std::int32_t>(n) ? j : s.ghost[static_cast<std::size_t>(j) - n].source;
      add_slot(s.list, static_cast<std::int32_t>(k), j, owner,
               s.coefficients.pair(a.material, b.material, a.mass, b.mass, a.radius, b.radius,
                                   is_glued(s, a.grain, b.grain)));
    }
  }
  s.list.pairs = s.list.size();
}

void list_walls(Sample& s) {
  ContactList& list = s.list;
  for (std::size_t k = 0; k < s.count; ++k) {
    const auto& d = s.record[k];
    for (int side = 0; side < 4; ++side) {
      const auto& wall = s.domain.wall[static_cast<std::size_t>(side)];
      if (!wall.present) continue;
      const double place = side < bottom ? d.x : d.y;
      const double distance = (side % 2 == 0) ? place - wall.position : wall.position - place;
      if (distance < d.radius + s.skin)
        add_slot(list, static_cast<std::int32_t>(k), wall_partner(side), -1, s.coefficients.wall(d.material, d.mass));
    }
  }
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
  list.first.assign(2 * s.count + 1, 0);
  for (std::size_t q = 0; q < 2 * s.count; ++q) list.first[q + 1] = list.first[q] + groups(used[q]);
  list.group.assign(static_cast<std::size_t>(list.first.back()), none);
  std::vector<std::int32_t> next = list.first;
  const auto put = [&](std::size_t q, std::size_t p) {
    list.group[static_cast<std::size_t>(next[q]++)] = static_cast<std::int32_t>(p);
  };
  for (std::size_t p = 0; p < list.size(); ++p) {
    put(2 * static_cast<std::size_t>(list.i[p]), p);
    if (list.owner[p] >= 0) put(2 * static_cast<std::size_t>(list.owner[p]) + 1, p);
  }
}

std::vector<Carried> carried(const Sample& s) {
  std::vector<Carried> all;
  for (std::size_t p = 0; p < s.list.size(); ++p)
    if (s.list.memory[p] != 0 || s.list.bond[p] != never_touched)
      all.push_back({slot_key(s, p), s.list.memory[p], s.list.bond[p]});
  std::sort(all.begin(), all.end(), [](const Carried& p, const Carried& q) { return p.key < q.key; });
  return all;
}

}  // namespace

void refresh_ghosts(Sample& s) {
  const double width = s.domain.width(), height = s.domain.height();
  const double stretch_x = s.domain.periodic_x ? s.domain.wall[right].velocity - s.domain.wall[left].velocity : 0;
  const double stretch_y = s.domain.periodic_y ? s.domain.wall[top].velocity - s.domain.wall[bottom].velocity : 0;
  for (std::size_t g = 0; g < s.ghost.size(); ++g) {
    const Ghost& ghost = s.ghost[g];
    DiskRecord& d = s.record[s.count + g];
    d = s.record[static_cast<std::size_t>(ghost.source)];
    d.x += ghost.shift_x * width + ghost.shift_y * s.domain.tilt;
    d.y += ghost.shift_y * height;
    d.vx += ghost.shift_x * stretch_x + ghost.shift_y * s.domain.tilt * stretch_x / width;
    d.vy += ghost.shift_y * stretch_y;
  }
}

void list_contacts(Sample& s) {
  make_ghosts(s);
  s.list.clear();
  list_pairs(s);
  list_walls(s);
  group_slots(s);
  s.list.force.assign(s.list.size() + 1, SlotForce{});
  s.list.memory.assign(s.list.size(), 0.0);
  s.list.bond.assign(s.list.size(), never_touched);
}

void carry_into(Sample& s, const std::vector<Carried>& all) {
  if (all.empty()) return;
  for (std::size_t p = 0; p < s.list.size(); ++p) {
    const std::uint64_t key = slot_key(s, p);
    const auto found = std::lower_bound(all.begin(), all.end(), key,
                                        [](const Carried& c, std::uint64_t k) { return c.key < k; });
    if (found == all.end() || found->key != key) continue;
    s.list.memory[p] = found->memory;
    s.list.bond[p] = found->bond;
  }
}

void bond_touching_pairs(Sample& s) {
  s.live_bonds.clear();
  if (s.glue && s.contact.adhesion == Adhesion::geometrical_breaking) {
    for (std::size_t p = 0; p < s.list.pairs; ++p) {
      const auto& a = s.record[static_cast<std::size_t>(s.list.i[p])];
      const auto& b = s.record[static_cast<std::size_t>(s.list.j[p])];
      const double reach = (1 + 1e-6) * (a.radius + b.radius);
      const Vec2 d{a.x - b.x, a.y - b.y};
      if (dot(d, d) < reach * reach && is_named(s, a.grain, b.grain)) s.live_bonds.push_back(slot_key(s, p));
    }
    std::sort(s.live_bonds.begin(), s.live_bonds.end());
  }
  ContactList& list = s.list;
  for (std::size_t p = 0; p < list.pairs; ++p) {
    const auto& a = s.record[static_cast<std::size_t>(list.i[p])];
    const auto& b = s.record[static_cast<std::size_t>(list.j[p])];
    list.strength[p] = s.coefficients.pair(a.material, b.material, a.mass, b.mass, a.radius, b.radius,
                                           is_glued(s, a.grain, b.grain)).strength;
  }
}

void rebuild_list(Sample& s) {
  check_places(s);
  const auto kept = carried(s);
  wrap(s);
  sort_by_cell(s);
  s.listed_x.resize(s.count);
  s.listed_y.resize(s.count);
  for (std::size_t k = 0; k < s.count; ++k) {
    s.listed_x[k] = s.record[k].x;
    s.listed_y[k] = s.record[k].y;
  }
  s.listed_domain = s.domain;
  ++s.builds;
  list_contacts(s);
  carry_into(s, kept);
}

double list_leeway(const Sample& s) {
  for (std::size_t side = 0; side < 4; ++side) {
    const bool periodic = side < bottom ? s.domain.periodic_x : s.domain.periodic_y;
    const double moved = std::abs(s.domain.wall[side].position - s.listed_domain.wall[side].position);
    if (!periodic && moved > 0.5 * s.skin) return 0;
  }
  const CellFrame then = cell_frame(s.listed_domain), now = cell_frame(s.domain);
  return 0.5 * (s.skin - reach_of(s) * (std::abs(now.width / then.width - 1) * now.periodic_x +
                                        std::abs(now.height / then.height - 1) * now.periodic_y));
}

}  // namespace arenite::dem
