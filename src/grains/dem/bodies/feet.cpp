#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/cell_grid.hpp"
#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/bodies/cores.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/neighbours.hpp"
#include "model/shapes.hpp"

namespace arenite::dem {
namespace {

/// The cores that disk k may touch soon, with images in a fixed order.
void find_cores(const Sample& s, const std::vector<Core>& cores, const geometry::CellGrid& grid, const geometry::SortedCells& cells, std::size_t k,
                std::vector<std::int32_t>& near) {
  near.clear();
  const DiskRecord& d = s.record[k];
  const std::int32_t own = body_of(s, d.grain);
  cells.for_near(grid, d.place.x, d.place.y, [&](std::int32_t at) {
    const Core& core = cores[at];
    if (core.body == own || norm(d.place - core.middle) > core.reach + d.radius + s.skin) return;
    const Nearest found = nearest_on(core, d.place);
    if (found.inside) refuse_inside(s, "grain " + std::to_string(s.given.id[grain_of(s, d.grain)]), core);
    if (norm(d.place - found.place) < d.radius + rounding_of(s, core.body) + s.skin) near.push_back(at);
  });
  std::sort(near.begin(), near.end());
}

/// In which periodic cell a place lies, counted from the one of now.
Cells cell_of(const Domain& domain, Vec2 place) {
  Cells cell;
  if (domain.periodic_x) cell.x = static_cast<std::int32_t>(std::floor((place.x - domain.wall[left].position) / domain.width()));
  if (domain.periodic_y) cell.y = static_cast<std::int32_t>(std::floor((place.y - domain.wall[bottom].position) / domain.height()));
  return cell;
}

/// The record of a foot where it is now; its polygon's place nearest to what it touches.
void place_foot(const Sample& s, Foot& foot, DiskRecord& at) {
  const Body& b = s.body[foot.body];
  const std::int32_t source = s.part_disk[b.first];
  const Vec2 place = is_boundary(foot.touches) ? touched_point(s, foot.touches) : s.record[foot.touches].place;
  // That place as the polygon's own image sees it, from the centre of the polygon: what levers are counted from.
  const Vec2 by = image_place(s, foot.shift), centre = corner_of(s, b.first) - s.lever[source];
  const auto lever = [&](std::size_t n) { return s.lever[s.part_disk[b.first + n]]; };
  foot.lever = nearest_on(static_cast<std::size_t>(b.count), lever, place - by - centre).place;
  at = s.record[source];
  at.place = centre + foot.lever + by;
  // Along x before along y: the sums that results so far were made with.
  at.velocity = b.seen.velocity + b.seen.omega * perpendicular(foot.lever) + image_velocity(s, {foot.shift.x, 0}) + image_velocity(s, {0, foot.shift.y});
  at.omega = b.seen.omega;
}

/// Torques about the disks of a foot's polygon that take them, by the ways from there to the foot, where the slot's force acts.
double shifted_torque_i(const Sample& s, std::size_t slot, const Foot& foot) { return cross(foot.lever - s.lever[s.list.i[slot]], s.list.force[slot].on_i); }
double shifted_torque_j(const Sample& s, std::size_t slot, const Foot& foot) {
  return cross(foot.lever - s.lever[s.list.owner[slot]], -s.list.force[slot].on_i);
}

}  // namespace

std::vector<Foot> find_feet(const Sample& s, const Team& team) {
  double reach = largest_core(s);
  if (reach == 0) return {};
  reach += s.largest_radius + s.skin;
  const std::vector<Core> cores = all_cores(s, reach);
  const geometry::CellGrid frame = cells_of(s);
  const double width = frame.columns / frame.inverse_x, height = frame.rows / frame.inverse_y;
  const geometry::CellGrid grid(frame.x0, frame.y0, width, height, reach);
  const geometry::SortedCells cells(grid, 0, cores.size(), [&](std::size_t c) { return grid.cell(cores[c].middle.x, cores[c].middle.y); });
  constexpr std::size_t disks_of_block = 64;
  std::vector<std::vector<Foot>> blocks((s.count + disks_of_block - 1) / disks_of_block);
  team.for_ranges(blocks.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<std::int32_t> near;
    for (std::size_t block = begin; block < end; ++block)
      for (std::size_t k = block * disks_of_block; k < std::min(s.count, (block + 1) * disks_of_block); ++k) {
        find_cores(s, cores, grid, cells, k, near);
        for (const std::int32_t at : near) {
          const Core& core = cores[at];
          blocks[block].push_back({static_cast<std::int32_t>(k), core.body, core.shift, {}});
        }
      }
  });
  std::vector<Foot> feet;
  for (const auto& block : blocks) feet.insert(feet.end(), block.begin(), block.end());
  return feet;
}

std::vector<Foot> find_point_feet(const Sample& s) {
  std::vector<Foot> feet;
  const double largest = s.element.empty() ? 0 : largest_core(s);
  if (largest == 0) return feet;
  const std::vector<Core> cores = all_cores(s, largest + s.skin);
  for (std::size_t e = 0; e < s.element.size(); ++e) {
    const Element& element = s.element[e];
    const Boundary& boundary = s.domain.boundaries[element.boundary];
    if (element.segment || !boundary.present) continue;
    const auto point = static_cast<std::size_t>(element.point);
    if (point + 1 == boundary.points.size() && goes_through_sides(s.domain, boundary)) continue;
    const Cells cell = cell_of(s.domain, boundary.points[point]);
    const Vec2 place = boundary.points[point] - image_place(s, cell);
    for (const Core& core : cores) {
      if (norm(place - core.middle) > core.reach + s.skin) continue;
      const Nearest found = nearest_on(core, place);
      if (found.inside) refuse_inside(s, "a point of the boundary \"" + boundary.name + "\"", core);
      if (norm(place - found.place) < rounding_of(s, core.body) + s.skin && juts_out(s.domain, boundary, point, boundary.points[point] + (found.place - place)))
        feet.push_back({boundary_partner(static_cast<int>(e)), core.body, {core.shift.x + cell.x, core.shift.y + cell.y}, {}});
    }
  }
  return feet;
}

void refresh_feet(Sample& s) {
  const std::size_t behind = s.count + s.ghost.size(), first = behind - s.foot.size();
  for (std::size_t f = 0; f < s.foot.size(); ++f) place_foot(s, s.foot[f], s.record[first + f]);
  for (std::size_t f = 0; f < s.point_foot.size(); ++f) place_foot(s, s.point_foot[f], s.record[behind + f]);
}

const Foot* foot_of(const Sample& s, std::size_t slot) {
  if (s.foot.empty() || slot >= s.list.pairs) return nullptr;
  const auto first = static_cast<std::int32_t>(s.count + s.ghost.size() - s.foot.size());
  const std::int32_t j = s.list.j[slot];
  return j >= first ? &s.foot[j - first] : nullptr;
}

const Foot* point_foot_of(const Sample& s, std::size_t slot) { return slot < s.list.polygons ? nullptr : &s.point_foot[slot - s.list.polygons]; }

void take_torques_to_owners(Sample& s, const Team& team) {
  const std::size_t feet = s.foot.size(), first = s.list.pairs - feet;
  if (feet > 0)
    team.for_ranges(feet, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = first + begin; p < first + end; ++p)
        if (acts(s.list.force[p])) s.list.force[p].torque_j += shifted_torque_j(s, p, s.foot[p - first]);
    });
  for (std::size_t p = s.list.polygons; p < s.list.size(); ++p)
    if (acts(s.list.force[p])) s.list.force[p].torque_i += shifted_torque_i(s, p, *point_foot_of(s, p));
}

Vec2 own_lever(const Sample& s, std::size_t slot) {
  const Foot* foot = point_foot_of(s, slot);
  return foot ? foot->lever : lever_of(s, s.list.i[slot]);
}

double own_torque_i(const Sample& s, std::size_t slot) {
  const Foot* foot = point_foot_of(s, slot);
  return s.list.force[slot].torque_i - (foot ? shifted_torque_i(s, slot, *foot) : 0.0);
}

Vec2 partner_lever(const Sample& s, std::size_t slot) {
  if (s.part.empty() || s.list.j[slot] < 0) return {};
  const Foot* foot = foot_of(s, slot);
  return foot ? foot->lever : s.lever[s.list.owner[slot]];
}

double own_torque_j(const Sample& s, std::size_t slot) {
  const Foot* foot = foot_of(s, slot);
  return s.list.force[slot].torque_j - (foot ? shifted_torque_j(s, slot, *foot) : 0.0);
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

}  // namespace arenite::dem
