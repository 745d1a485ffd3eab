#include "grains/dem/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

void check_places(const Sample& s) {
  for (std::size_t k = 0; k < s.count; ++k) {
    const auto& d = s.record[k];
    const char* fault = nullptr;
    if (!std::isfinite(d.place.x + d.place.y + d.velocity.x + d.velocity.y + d.omega)) fault = " has a coordinate or velocity that is not finite";
    for (int side = 0; side < 4 && !fault; ++side)
      if (s.domain.wall[side].present && s.domain.depth(side, d.place) < 0) fault = " has left the container through a wall";
    if (fault) {
      const auto id = s.start.grains.id[d.grain];
      const std::string what = "grain " + std::to_string(id) + fault;
      if (s.step == 0) throw InputError(what + " before the first step; correct its place, or the container");
      throw CannotGoOn(what + " at step " + std::to_string(s.step) + "; a smaller time step or a gentler load is needed");
    }
  }
}

void wrap(Sample& s) {
  if (s.domain.periodic[0]) s.domain.tilt -= std::round(s.domain.tilt / s.domain.width()) * s.domain.width();
  for (std::size_t k = 0; k < s.count; ++k)
    if (!is_part(s, k)) wrap_over_sides(s, s.record[k].mass, s.record[k].place, s.velocity.along[0][k], s.record[k].velocity);
}

template <class T> void permute(std::vector<T>& values, const std::vector<std::int32_t>& order) {
  if (values.empty()) return;
  std::vector<T> old(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(order.size()));
  for (std::size_t k = 0; k < order.size(); ++k) values[k] = old[order[k]];
}

/// Returns the former number of every disk.
std::vector<std::int32_t> sort_by_cell(Sample& s) {
  const auto grid = cells_of(s);
  std::vector<std::int32_t> order = geometry::SortedCells(grid.size(), 0, s.count, [&](std::size_t k) { return grid.cell(s.record[k].place); }).item;
  s.record.resize(s.count);
  permute(s.record, order);
  for (auto* a : motion_arrays(s)) permute(*a, order);
  for (auto& higher : s.higher)
    for (auto& a : higher.along) permute(a, order);
  return order;
}

/// The slot that joins disk a with disk b, or with wall b < 0, with the polygon of a itself where `as_polygon`; the empty slot if there is none.
/// `either`: b with a as well, which are two slots where the one that takes the reaction stands for a polygon.
std::size_t find_slot(const ContactList& list, std::int32_t a, std::int32_t b, bool as_polygon, bool either) {
  const auto slots = [&](std::int32_t q, auto&& joins) {
    for (auto g = list.first[q]; g < list.first[q + 1]; ++g) {
      const std::size_t p = list.group[g];
      if (p < list.size() && joins(p)) return p;
    }
    return list.size();
  };
  if (b < 0) return slots(2 * a, [&](std::size_t p) { return list.j[p] == b && (p >= list.polygons) == as_polygon; });
  const std::size_t own = slots(2 * a, [&](std::size_t p) { return list.owner[p] == b; });
  return own < list.size() || !either ? own : slots(2 * a + 1, [&](std::size_t p) { return list.i[p] == b; });
}

/// Takes over what touching pairs remember from the list before a rebuild; disk k was number `was[k]` in it. A periodic cell is at least two reaches
/// wide, so no pair meets twice.
void carry_over(Sample& s, ContactList& before, const std::vector<std::int32_t>& was, const ThreadPool& pool) {
  ContactList& list = s.list;
  if (before.size() == 0 || (s.live_bonds.empty() && !remembers(s.laws) && s.list.rolling_memory.empty() && s.list.pull.empty())) return;
  const auto now = list.memories(), then = before.memories();
  pool.for_ranges(list.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const std::int32_t a = was[list.i[p]];
      const std::int32_t b = list.j[p] < 0 ? list.j[p] : was[list.owner[p]];
      const std::size_t old = find_slot(before, a, b, p >= list.polygons, !foot_of(s, p));
      if (old == before.size()) continue;
      for (std::size_t m = 0; m < now.size(); ++m)
        if (p < now[m]->size()) (*now[m])[p] = (*then[m])[old];
      if (p < list.curve.size()) list.curve[p] = before.curve[old];
      list.bond[p] = before.bond[old];
    }
  });
}

bool bonds_break(const Sample& s) {
  return s.contact.adhesion.visit([](const auto& law) { return law.breaks; });
}

/// Whether grains a and b (caller's indices) attract each other.
bool is_glued(const Sample& s, std::int32_t a, std::int32_t b) {
  if (!s.glue || !s.contact.adheres()) return false;
  return bonds_break(s) ? std::binary_search(s.live_bonds.begin(), s.live_bonds.end(), pair_key(a, b)) : is_marked_as_glued(s, a, b);
}

}  // namespace

void wrap_over_sides(Sample& s, double mass, Vec2& place, double& own_x, Vec2& seen) {
  const CellMotion<2> cell = cell_motion(s.domain);
  const std::int32_t rows = s.domain.cell_of(place).y;
  const Vec2 wrapped = s.domain.wrapped(place);
  if (const double faster = -rows * s.shear_rate * s.domain.height(); faster != 0) {
    if (s.integration.track_energy) s.tally.work_walls += 0.5 * mass * faster * (2 * own_x + faster);
    own_x += faster;
    seen.x += faster;
  }
  place.x -= rows * s.domain.tilt;
  for (const int axis : {0, 1})
    if (s.domain.periodic[axis]) seen[axis] += cell.along[axis].at(wrapped[axis]) - cell.along[axis].at(place[axis]);
  place = wrapped;
}

void rebuild_list(Sample& s, const ThreadPool& pool) {
  check_places(s);
  check_crossings(s);
  wrap(s);
  wrap_bodies(s);
  wrap_boundaries(s.domain);
  const std::vector<std::int32_t> was = sort_by_cell(s);
  number_held(s);
  for (std::size_t h = 0; h < s.held.size(); ++h) {
    HeldGrain& held = s.held[h];
    held.place[1 - axis_of(held.side)] = along(held.side, s.record[s.held_disk[h]].place) - s.wall[held.side].slid;
  }
  for (auto& a : s.listed.along) a.resize(s.count);
  for (std::size_t k = 0; k < s.count; ++k) s.listed.put(k, s.record[k].place);
  s.listed_domain = s.domain;
  s.listed_sheared = s.sheared;
  ++s.builds;
  std::swap(s.list, s.former);
  list_contacts(s, pool);
  carry_over(s, s.former, was, pool);
}

geometry::Box<2> room_of(const Sample& s) {
  Vec2 edge[] = {s.domain.corner(0), s.domain.corner(1)};
  for (int side = 0; side < sides; ++side) {
    if (!s.wall[side].open) continue;
    double beyond = 0;
    for (std::size_t k = 0; k < s.count; ++k) beyond = std::max(beyond, -s.domain.depth(side, s.record[k].place));
    edge[side % 2][axis_of(side)] -= inward_sign(side) * std::min(beyond, s.domain.extent(axis_of(side)));
  }
  return {edge[0], edge[1] - edge[0]};
}

void number_held(Sample& s) {
  s.held_disk.assign(s.held.size(), 0);
  s.held_angle.assign(s.held.size(), 0.0);
  if (s.held.empty()) return;
  for (std::size_t k = 0; k < s.count; ++k) {
    const HeldGrain* held = find_held(s, s.record[k].grain);
    if (!held) continue;
    const auto h = held - s.held.data();
    s.held_disk[h] = static_cast<std::int32_t>(k);
    s.held_angle[h] = s.angle[k];
  }
}

void hold_grains(Sample& s) {
  for (std::size_t h = 0; h < s.held.size(); ++h) {
    const HeldGrain& held = s.held[h];
    const std::int32_t k = s.held_disk[h];
    const WallBody& body = s.wall[held.side];
    const Wall& wall = s.domain.wall[held.side];
    DiskRecord& d = s.record[k];
    d.place = held.place + of_side(held.side, wall.position, body.slid);
    d.velocity = of_side(held.side, wall.velocity, body.drive.slide);
    s.velocity.put(k, of_side(held.side, body.rate, body.drive.slide));
    s.acceleration.put(k, {});
    s.angle[k] = s.held_angle[h];
    d.omega = s.omega[k] = s.alpha[k] = 0;
    for (auto& higher : s.higher)
      if (!higher.along[0].empty()) higher.put(k, {});
  }
}

double list_leeway(const Sample& s) {
  for (int side = 0; side < sides; ++side)
    if (!s.domain.is_periodic(side) && std::abs(s.domain.wall[side].position - s.listed_domain.wall[side].position) > 0.5 * s.skin) return 0;
  if (farthest_moved(s.listed_domain, s.domain) > 0.5 * s.skin) return 0;
  const CellFrame<2> then = cell_frame(s.listed_domain), now = cell_frame(s.domain);
  const double growth = std::abs(now[0].since(then[0]).growth()) + std::abs(now[1].since(then[1]).growth());
  return 0.5 * (s.skin - reach_of(s) * (growth + std::abs(s.sheared - s.listed_sheared)));
}

bool is_marked_as_glued(const Sample& s, std::int32_t a, std::int32_t b) {
  const auto& zone = s.start.grains.zone;
  const auto& glued = s.contact.glued_pairs;  // sorted, low index first
  if (glued.empty()) return zone[a] > 0 && zone[b] > 0;
  a = grain_of(s, a), b = grain_of(s, b);
  return std::binary_search(glued.begin(), glued.end(), std::pair{std::min(a, b), std::max(a, b)});
}

Coefficients pair_coefficients(const Sample& s, const DiskRecord& a, const DiskRecord& b) { return s.coefficients.pair(a, b, is_glued(s, a.grain, b.grain)); }

void bond_touching_pairs(Sample& s) {
  s.live_bonds.clear();
  if (s.glue && bonds_break(s)) {
    for (std::size_t p = 0; p < s.list.pairs; ++p) {
      const DiskRecord &a = s.record[s.list.i[p]], &b = s.record[s.list.j[p]];
      const double reach = (1 + 1e-6) * (a.radius + b.radius);
      const Vec2 d = a.place - b.place;
      if (dot(d, d) < reach * reach && is_marked_as_glued(s, a.grain, b.grain)) s.live_bonds.push_back(slot_key(s, p));
    }
    std::sort(s.live_bonds.begin(), s.live_bonds.end());
  }
  for (std::size_t p = 0; p < s.list.pairs; ++p) s.list.strength[p] = pair_coefficients(s, s.record[s.list.i[p]], s.record[s.list.j[p]]).strength;
}

}  // namespace arenite::dem
