#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "geometry/cell_grid.hpp"
#include "geometry/rectangle.hpp"
#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/neighbours.hpp"
#include "model/shapes.hpp"

namespace arenite::dem {
namespace {

/// The core of a polygon, the convex polygon of its corners' centres, in one periodic image: where its corners are, m.
struct Core {
  std::int32_t body = 0;
  Cells shift;
  Vec2 middle;
  double reach = 0;  ///< of its widened rim from the middle
  std::vector<Vec2> corner;
};

/// The corner where its body's own image is, from the record.
Vec2 corner_of(const Sample& s, std::size_t d) { return s.record[s.part_disk[d]].place - image_place(s, s.part[d].shift); }

/// Radius of a polygon's corners, m.
double rounding_of(const Sample& s, std::int32_t body) { return s.start.grains.radius[s.body[body].first]; }

Core core_of(const Sample& s, std::size_t body) {
  const Body& b = s.body[body];
  Core core;
  core.body = static_cast<std::int32_t>(body);
  for (std::int32_t d = b.first; d < b.first + b.count; ++d) core.corner.push_back(corner_of(s, static_cast<std::size_t>(d)));
  core.middle = mean_point(core.corner);
  for (const Vec2& p : core.corner) core.reach = std::max(core.reach, norm(p - core.middle) + rounding_of(s, core.body));
  return core;
}

/// The farthest that the rim of a polygon is from the middle of its core, m; 0 where there are no polygons.
double largest_core(const Sample& s) {
  double reach = 0;
  for (std::size_t b = 0; b < s.body.size(); ++b)
    if (s.body[b].filled) reach = std::max(reach, core_of(s, b).reach);
  return reach;
}

/// Every polygon, and its images where their middles come as near to the cell as `reach`, m.
std::vector<Core> all_cores(const Sample& s, double reach) {
  const int across = s.domain.periodic[0] ? 1 : 0, up = s.domain.periodic[1] ? 1 : 0;
  const auto& w = s.domain.wall;
  std::vector<Core> cores;
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    if (!s.body[b].filled) continue;
    const Core own = core_of(s, b);
    for (int iy = -up; iy <= up; ++iy)
      for (int ix = -across; ix <= across; ++ix) {
        const Vec2 by = image_place(s, {ix, iy}), at = own.middle + by;
        const bool near_x = !s.domain.periodic[0] || (at.x > w[left].position - reach && at.x < w[right].position + reach);
        const bool near_y = !s.domain.periodic[1] || (at.y > w[bottom].position - reach && at.y < w[top].position + reach);
        if (!near_x || !near_y) continue;
        Core& core = cores.emplace_back(own);
        core.shift = {ix, iy};
        core.middle = at;
        for (Vec2& p : core.corner) p += by;
      }
  }
  return cores;
}

struct Nearest {
  Vec2 place;
  bool inside = true;
};
/// The nearest point of a convex polygon's rim to a place.
template <class Corner> Nearest nearest_on(std::size_t corners, Corner corner, Vec2 place) {
  Nearest found;
  double least = std::numeric_limits<double>::infinity();
  Vec2 from = corner(corners - 1);
  for (std::size_t k = 0; k < corners; ++k) {
    const Vec2 to = corner(k), along = to - from, way = place - from;
    const Vec2 foot = geometry::nearest_on_segment(from, to, place);
    if (const double d = dot(place - foot, place - foot); d < least) least = d, found.place = foot;
    if (cross(along, way) <= 0) found.inside = false;
    from = to;
  }
  return found;
}
inline Nearest nearest_on(const Core& core, Vec2 place) {
  return nearest_on(
      core.corner.size(), [&](std::size_t n) { return core.corner[n]; }, place);
}

/// Throws InputError before the first step, CannotGoOn later: something, "grain 3", lies within a polygon's core.
[[noreturn]] void refuse_inside(const Sample& s, const std::string& what, const Core& core) {
  const Body& b = s.body[core.body];
  const auto id = s.given.id[s.part[b.first].grain];
  const std::string where = what + " lies within polygon " + std::to_string(id);
  if (s.step == 0) throw InputError(where + " before the first step; place the grains farther apart");
  throw CannotGoOn(where + " at step " + std::to_string(s.step) + "; stiffer contacts, rounder corners or a gentler load are needed");
}

/// The cores that disk k may touch soon, with images in a fixed order.
void find_cores(const Sample& s, const std::vector<Core>& cores, const geometry::CellGrid<2>& grid, const geometry::SortedCells& cells, std::size_t k,
                std::vector<std::int32_t>& near) {
  near.clear();
  const DiskRecord& d = s.record[k];
  const std::int32_t own = body_of(s, d.grain);
  cells.for_near(grid, d.place, [&](std::int32_t at) {
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
  if (domain.periodic[0]) cell.x = static_cast<std::int32_t>(std::floor((place.x - domain.wall[left].position) / domain.width()));
  if (domain.periodic[1]) cell.y = static_cast<std::int32_t>(std::floor((place.y - domain.wall[bottom].position) / domain.height()));
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

}  // namespace

std::vector<Foot> find_feet(const Sample& s, const ThreadPool& pool) {
  double reach = largest_core(s);
  if (reach == 0) return {};
  reach += s.largest_radius + s.skin;
  const std::vector<Core> cores = all_cores(s, reach);
  const geometry::CellGrid<2> grid(room_of(s), reach);
  const geometry::SortedCells cells(grid.size(), 0, cores.size(), [&](std::size_t c) { return grid.cell(cores[c].middle); });
  constexpr std::size_t disks_of_block = 64;
  std::vector<std::vector<Foot>> blocks((s.count + disks_of_block - 1) / disks_of_block);
  pool.for_ranges(blocks.size(), [&](std::size_t begin, std::size_t end) {
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

}  // namespace arenite::dem
