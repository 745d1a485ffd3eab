#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "geometry/cell_grid.hpp"
#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/neighbours.hpp"
#include "model/shapes.hpp"

namespace arenite::dem {
namespace {

/// A polygon in one periodic image: where its corners are, m.
struct Core {
  std::int32_t body = 0, shift_x = 0, shift_y = 0;
  Vec2 middle;
  double reach = 0;  ///< of its widened rim from the middle
  std::vector<Vec2> corner;
};

Vec2 image(const Sample& s, int shift_x, int shift_y) { return {shift_x * s.domain.width() + shift_y * s.domain.tilt, shift_y * s.domain.height()}; }

/// The corner where its body's own image is, from the record.
Vec2 corner_of(const Sample& s, std::size_t d) {
  const DiskRecord& r = s.record[static_cast<std::size_t>(s.part_disk[d])];
  return Vec2{r.x, r.y} - image(s, s.part[d].shift_x, s.part[d].shift_y);
}

double rounding(const Sample& s, const Body& b) { return s.start.grains.radius[static_cast<std::size_t>(b.first)]; }

Core core_of(const Sample& s, std::size_t body) {
  const Body& b = s.body[body];
  Core core;
  core.body = static_cast<std::int32_t>(body);
  for (std::int32_t d = b.first; d < b.first + b.count; ++d) core.corner.push_back(corner_of(s, static_cast<std::size_t>(d)));
  core.middle = mean_point(core.corner);
  for (const Vec2& p : core.corner) core.reach = std::max(core.reach, norm(p - core.middle) + rounding(s, b));
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
    const Vec2 foot = from + std::clamp(dot(way, along) / dot(along, along), 0.0, 1.0) * along;
    if (const double d = dot(place - foot, place - foot); d < least) least = d, found.place = foot;
    if (cross(along, way) <= 0) found.inside = false;
    from = to;
  }
  return found;
}

/// Every polygon, and its images where they come within reach of disks in the cell.
std::vector<Core> all_cores(const Sample& s, double reach) {
  const int across = s.domain.periodic_x ? 1 : 0, up = s.domain.periodic_y ? 1 : 0;
  const auto& w = s.domain.wall;
  std::vector<Core> cores;
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    if (!s.body[b].filled) continue;
    const Core own = core_of(s, b);
    for (int iy = -up; iy <= up; ++iy)
      for (int ix = -across; ix <= across; ++ix) {
        const Vec2 by = image(s, ix, iy), at = own.middle + by;
        const bool near_x = !s.domain.periodic_x || (at.x > w[left].position - reach && at.x < w[right].position + reach);
        const bool near_y = !s.domain.periodic_y || (at.y > w[bottom].position - reach && at.y < w[top].position + reach);
        if (!near_x || !near_y) continue;
        Core& core = cores.emplace_back(own);
        core.shift_x = ix;
        core.shift_y = iy;
        core.middle = at;
        for (Vec2& p : core.corner) p += by;
      }
  }
  return cores;
}

[[noreturn]] void refuse_inside(const Sample& s, std::size_t k, const Core& core) {
  const auto id = [&](std::int32_t grain) { return std::to_string(s.given.id[static_cast<std::size_t>(grain)]); };
  const Body& b = s.body[static_cast<std::size_t>(core.body)];
  const std::string what = "grain " + id(grain_of(s, s.record[k].grain)) + " lies within polygon " + id(s.part[static_cast<std::size_t>(b.first)].grain);
  if (s.step == 0) throw InputError(what + " before the first step; place the grains farther apart");
  throw CannotGoOn(what + " at step " + std::to_string(s.step) + "; stiffer contacts, rounder corners or a gentler load are needed");
}

/// The cores that disk k may touch soon, with images in a fixed order.
void find_cores(const Sample& s, const std::vector<Core>& cores, const geometry::CellGrid& grid, const geometry::SortedCells& cells, std::size_t k,
                std::vector<std::int32_t>& near) {
  near.clear();
  const DiskRecord& d = s.record[k];
  const Vec2 place{d.x, d.y};
  const std::int32_t row = grid.row(d.y), column = grid.column(d.x), own = body_of(s, d.grain);
  for (std::int32_t r = std::max(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r)
    for (std::int32_t c = std::max(column - 1, 0); c <= std::min(column + 1, grid.columns - 1); ++c) {
      const auto cell = static_cast<std::size_t>(r * grid.columns + c);
      for (std::int32_t q = cells.first[cell]; q < cells.first[cell + 1]; ++q) {
        const std::int32_t at = cells.item[static_cast<std::size_t>(q)];
        const Core& core = cores[static_cast<std::size_t>(at)];
        if (core.body == own || norm(place - core.middle) > core.reach + d.radius + s.skin) continue;
        const Nearest found = nearest_on(
            core.corner.size(), [&](std::size_t n) { return core.corner[n]; }, place);
        if (found.inside) refuse_inside(s, k, core);
        if (norm(place - found.place) < d.radius + rounding(s, s.body[static_cast<std::size_t>(core.body)]) + s.skin) near.push_back(at);
      }
    }
  std::sort(near.begin(), near.end());
}

}  // namespace

std::vector<Foot> find_feet(const Sample& s, const Team& team) {
  double reach = 0;
  for (std::size_t b = 0; b < s.body.size(); ++b)
    if (s.body[b].filled) reach = std::max(reach, core_of(s, b).reach);
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
          const Core& core = cores[static_cast<std::size_t>(at)];
          blocks[block].push_back({static_cast<std::int32_t>(k), core.body, core.shift_x, core.shift_y, {}});
        }
      }
  });
  std::vector<Foot> feet;
  for (const auto& block : blocks) feet.insert(feet.end(), block.begin(), block.end());
  return feet;
}

void refresh_feet(Sample& s) {
  const std::size_t first = s.count + s.ghost.size() - s.foot.size();
  const double stretch_x = s.domain.periodic_x ? s.domain.wall[right].velocity - s.domain.wall[left].velocity : 0;
  const double stretch_y = s.domain.periodic_y ? s.domain.wall[top].velocity - s.domain.wall[bottom].velocity : 0;
  for (std::size_t f = 0; f < s.foot.size(); ++f) {
    Foot& foot = s.foot[f];
    const Body& b = s.body[static_cast<std::size_t>(foot.body)];
    const DiskRecord& d = s.record[static_cast<std::size_t>(foot.disk)];
    const auto source = static_cast<std::size_t>(s.part_disk[static_cast<std::size_t>(b.first)]);
    // The disk's place as the polygon's own image sees it, from the centre of the polygon: what levers are counted from.
    const Vec2 by = image(s, foot.shift_x, foot.shift_y), centre = corner_of(s, static_cast<std::size_t>(b.first)) - s.lever[source];
    const auto lever = [&](std::size_t n) { return s.lever[static_cast<std::size_t>(s.part_disk[static_cast<std::size_t>(b.first) + n])]; };
    foot.lever = nearest_on(static_cast<std::size_t>(b.count), lever, Vec2{d.x, d.y} - by - centre).place;
    DiskRecord& at = s.record[first + f];
    at = s.record[source];
    at.x = centre.x + foot.lever.x + by.x;
    at.y = centre.y + foot.lever.y + by.y;
    at.vx = b.seen_x - b.seen_omega * foot.lever.y + foot.shift_x * stretch_x +
            foot.shift_y * (s.domain.tilt * stretch_x / s.domain.width() + s.shear_rate * s.domain.height());
    at.vy = b.seen_y + b.seen_omega * foot.lever.x + foot.shift_y * stretch_y;
    at.omega = b.seen_omega;
  }
}

const Foot* foot_of(const Sample& s, std::size_t slot) {
  if (s.foot.empty() || slot >= s.list.pairs) return nullptr;
  const auto first = static_cast<std::int32_t>(s.count + s.ghost.size() - s.foot.size());
  const std::int32_t j = s.list.j[slot];
  return j >= first ? &s.foot[static_cast<std::size_t>(j - first)] : nullptr;
}

namespace {

/// Torque about the disk that owns a foot's reaction by the way from that disk to the foot.
double shifted_torque(const Sample& s, std::size_t slot, const Foot& foot) {
  const SlotForce& f = s.list.force[slot];
  return cross(foot.lever - s.lever[static_cast<std::size_t>(s.list.owner[slot])], Vec2{-f.fx, -f.fy});
}

}  // namespace

void take_reactions_to_owners(Sample& s, const Team& team) {
  const std::size_t feet = s.foot.size(), first = s.list.pairs - feet;
  team.for_ranges(feet, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = first + begin; p < first + end; ++p)
      if (acts(s.list.force[p])) s.list.force[p].torque_j += shifted_torque(s, p, s.foot[p - first]);
  });
}

Vec2 partner_lever(const Sample& s, std::size_t slot) {
  if (s.part.empty() || s.list.j[slot] < 0) return {};
  const Foot* foot = foot_of(s, slot);
  return foot ? foot->lever : s.lever[static_cast<std::size_t>(s.list.owner[slot])];
}

double own_torque_j(const Sample& s, std::size_t slot) {
  const Foot* foot = foot_of(s, slot);
  return s.list.force[slot].torque_j - (foot ? shifted_torque(s, slot, *foot) : 0.0);
}

int rows_between(const Sample& s, std::size_t slot) {
  const std::int32_t j = s.list.j[slot], n = static_cast<std::int32_t>(s.count);
  if (j < 0) return 0;
  const Foot* foot = foot_of(s, slot);
  int rows = foot ? foot->shift_y : j >= n ? s.ghost[static_cast<std::size_t>(j - n)].shift_y : 0;
  if (s.part.empty()) return rows;
  const auto shift = [&](std::int32_t k) { return s.part[static_cast<std::size_t>(s.record[static_cast<std::size_t>(k)].grain)].shift_y; };
  if (!foot) rows += shift(s.list.owner[slot]);
  return rows - shift(s.list.i[slot]);
}

}  // namespace arenite::dem
