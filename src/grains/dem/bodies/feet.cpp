#include "grains/dem/bodies/feet.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "geometry/cell_grid.hpp"
#include "geometry/rectangle.hpp"
#include "grains/dem/boundaries/elements.hpp"
#include "grains/dem/neighbours.hpp"
#include "model/shapes.hpp"

namespace arenite::dem {
namespace {

/// The core of a polygon, the convex polygon of its corners' centres, in one periodic image: where its corners are, m.
struct Core {
  std::int32_t body = 0;
  Cells<2> shift;
  Vec2 middle;
  double reach = 0;  ///< of its widened rim from the middle
  std::vector<Vec2> corner;
};

/// The corner where its body's own image is, from the record.
Vec2 corner_of(const Sample& s, std::size_t d) {
  return s.record[the<Bodies>(s).disk[d]].place - s.domain.way(the<Bodies>(s).part[d].shift);
}

/// Radius of a polygon's corners, m.
double rounding_of(const Sample& s, std::int32_t body) {
  return s.start.grains.radius[the<Bodies>(s).body[body].first];
}

Core core_of(const Sample& s, std::size_t body) {
  const Body& b = the<Bodies>(s).body[body];
  Core core;
  core.body = static_cast<std::int32_t>(body);
  for (std::int32_t d = b.first; d < b.first + b.count; ++d)
    core.corner.push_back(corner_of(s, static_cast<std::size_t>(d)));
  core.middle = mean_point(core.corner);
  for (const Vec2& p : core.corner)
    core.reach = std::max(core.reach, norm(p - core.middle) + rounding_of(s, core.body));
  return core;
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
  const Body& b = the<Bodies>(s).body[core.body];
  const auto id = the<Bodies>(s).caller.id[the<Bodies>(s).part[b.first].grain];
  const std::string where = what + " lies within polygon " + std::to_string(id);
  if (s.step == 0) throw InputError(where + " before the first step; place the grains farther apart");
  throw CannotGoOn(where + " at step " + std::to_string(s.step) +
                   "; stiffer contacts, rounder corners or a gentler load are needed");
}

/// The cores of all polygons and of their images that come near to the cell, sorted by place.
struct Cores {
  const Sample& s;
  std::vector<Core> core;
  geometry::CellGrid<2> grid;
  geometry::SortedCells cells;

  /// Calls `see(core, the point of it that is nearest)` for the polygons other than `own` that a disk at this place may
  /// touch soon, in a fixed order.
  template <class Name, class See>
  void near(Vec2 place, double radius, std::int32_t own, const Name& name, const See& see) const {
    std::vector<std::pair<std::int32_t, Vec2>> found;
    cells.for_near(grid, place, [&](std::int32_t at) {
      if (core[at].body == own || norm(place - core[at].middle) > core[at].reach + radius + s.skin) return;
      const Nearest nearest = nearest_on(core[at], place);
      if (nearest.inside) refuse_inside(s, name(), core[at]);
      if (norm(place - nearest.place) < radius + rounding_of(s, core[at].body) + s.skin)
        found.emplace_back(at, nearest.place);
    });
    std::ranges::sort(found, {}, &std::pair<std::int32_t, Vec2>::first);
    for (const auto& [at, point] : found) see(core[at], point);
  }
};

Cores all_cores(const Sample& s) {
  std::vector<Core> own, images;
  double reach = 0;
  for (std::size_t b = 0; b < the<Bodies>(s).body.size(); ++b)
    if (the<Bodies>(s).body[b].filled) reach = std::max(reach, own.emplace_back(core_of(s, b)).reach);
  reach += s.largest_radius + s.skin;
  for (const Core& polygon : own)
    s.domain.each_near_cell([&](Cells<2> cell) {
      const Vec2 by = s.domain.way(cell), at = polygon.middle + by;
      if (!s.domain.is_near(at, reach)) return;
      Core& image = images.emplace_back(polygon);
      image.shift = cell;
      image.middle = at;
      for (Vec2& p : image.corner) p += by;
    });
  const geometry::CellGrid<2> grid(room_of(s), reach);
  const geometry::SortedCells cells(grid.size(), 0, images.size(),
                                    [&](std::size_t c) { return grid.cell(images[c].middle); });
  return {s, std::move(images), grid, cells};
}

bool has_polygons(const Sample& s) {
  return std::ranges::any_of(the<Bodies>(s).body, [](const Body& b) { return b.filled != 0; });
}

/// The record of a foot where it is now; its polygon's place nearest to what it touches.
void place_foot(const Sample& s, Foot& foot, DiskRecord& at) {
  const Body& b = the<Bodies>(s).body[foot.body];
  const std::int32_t source = the<Bodies>(s).disk[b.first];
  const bool of_point = is_boundary(foot.touches);
  const Vec2 place = of_point ? boundary_of(s, foot.touches).points[touched_element(s, foot.touches).point]
                              : s.record[foot.touches].place;
  // That place as the polygon's own image sees it, from the centre of the polygon: what levers are counted from.
  const Vec2 by = s.domain.way(foot.shift), centre = corner_of(s, b.first) - the<Bodies>(s).lever[source];
  const auto lever = [&](std::size_t n) { return the<Bodies>(s).lever[the<Bodies>(s).disk[b.first + n]]; };
  foot.lever = nearest_on(static_cast<std::size_t>(b.count), lever, place - by - centre).place;
  at = s.record[source];
  at.place = centre + foot.lever + by;
  // Along x before along y: the sums that results so far were made with.
  at.velocity = b.seen.velocity + b.seen.omega * perpendicular(foot.lever) + image_velocity(s, {foot.shift.x, 0}) +
                image_velocity(s, {0, foot.shift.y});
  at.omega = b.seen.omega;
}

}  // namespace

std::vector<Foot> find_feet(const Sample& s, const ThreadPool& pool) {
  if (!has_polygons(s)) return {};
  const Cores cores = all_cores(s);
  const auto blocks =
      pool.by_blocks<std::vector<Foot>>(s.count, disks_of_block, [&](std::size_t k, std::vector<Foot>& feet) {
        const DiskRecord& d = s.record[k];
        const auto name = [&] { return "grain " + std::to_string(the<Bodies>(s).caller.id[grain_of(s, d.grain)]); };
        cores.near(d.place, d.radius, body_of(s, d.grain), name, [&](const Core& core, Vec2) {
          feet.push_back({static_cast<std::int32_t>(k), core.body, core.shift, {}});
        });
      });
  std::vector<Foot> feet;
  for (const auto& block : blocks) feet.insert(feet.end(), block.begin(), block.end());
  return feet;
}

std::vector<Foot> find_point_feet(const Sample& s) {
  std::vector<Foot> feet;
  if (the<Boundaries>(s).element.empty() || !has_polygons(s)) return feet;
  const Cores cores = all_cores(s);
  for (std::size_t e = 0; e < the<Boundaries>(s).element.size(); ++e) {
    const Element& element = the<Boundaries>(s).element[e];
    const Boundary& boundary = s.domain.boundaries[element.boundary];
    if (element.segment || !boundary.present) continue;
    const auto point = static_cast<std::size_t>(element.point);
    if (point + 1 == boundary.points.size() && goes_through_sides(s.domain, boundary)) continue;
    const Vec2 place = boundary.points[point];
    const Cells<2> cell = s.domain.cell_of(place);
    const Vec2 inside = place - s.domain.way(cell);
    const auto name = [&] { return "a point of the boundary \"" + boundary.name + "\""; };
    cores.near(inside, 0, -1, name, [&](const Core& core, Vec2 nearest) {
      if (juts_out(s.domain, boundary, point, place + (nearest - inside)))
        feet.push_back({boundary_partner(static_cast<int>(e)), core.body, core.shift + cell, {}});
    });
  }
  return feet;
}

void refresh_feet(Sample& s) {
  const std::size_t behind = s.count + s.ghost.size(), first = behind - the<Bodies>(s).foot.size();
  for (std::size_t f = 0; f < the<Bodies>(s).foot.size(); ++f)
    place_foot(s, the<Bodies>(s).foot[f], s.record[first + f]);
  for (std::size_t f = 0; f < the<Bodies>(s).point_foot.size(); ++f)
    place_foot(s, the<Bodies>(s).point_foot[f], s.record[behind + f]);
}

}  // namespace arenite::dem
