#include "grains/dem/bodies/cores.hpp"

#include "core/error.hpp"

namespace arenite::dem {
namespace {

Core core_of(const Sample& s, std::size_t body) {
  const Body& b = s.body[body];
  Core core;
  core.body = static_cast<std::int32_t>(body);
  for (std::int32_t d = b.first; d < b.first + b.count; ++d) core.corner.push_back(corner_of(s, static_cast<std::size_t>(d)));
  core.middle = mean_point(core.corner);
  for (const Vec2& p : core.corner) core.reach = std::max(core.reach, norm(p - core.middle) + rounding_of(s, core.body));
  return core;
}

}  // namespace

Vec2 corner_of(const Sample& s, std::size_t d) { return s.record[s.part_disk[d]].place - image_place(s, s.part[d].shift); }

double rounding_of(const Sample& s, std::int32_t body) { return s.start.grains.radius[s.body[body].first]; }

double largest_core(const Sample& s) {
  double reach = 0;
  for (std::size_t b = 0; b < s.body.size(); ++b)
    if (s.body[b].filled) reach = std::max(reach, core_of(s, b).reach);
  return reach;
}

std::vector<Core> all_cores(const Sample& s, double reach) {
  const int across = s.domain.periodic_x ? 1 : 0, up = s.domain.periodic_y ? 1 : 0;
  const auto& w = s.domain.wall;
  std::vector<Core> cores;
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    if (!s.body[b].filled) continue;
    const Core own = core_of(s, b);
    for (int iy = -up; iy <= up; ++iy)
      for (int ix = -across; ix <= across; ++ix) {
        const Vec2 by = image_place(s, {ix, iy}), at = own.middle + by;
        const bool near_x = !s.domain.periodic_x || (at.x > w[left].position - reach && at.x < w[right].position + reach);
        const bool near_y = !s.domain.periodic_y || (at.y > w[bottom].position - reach && at.y < w[top].position + reach);
        if (!near_x || !near_y) continue;
        Core& core = cores.emplace_back(own);
        core.shift = {ix, iy};
        core.middle = at;
        for (Vec2& p : core.corner) p += by;
      }
  }
  return cores;
}

void refuse_inside(const Sample& s, const std::string& what, const Core& core) {
  const Body& b = s.body[core.body];
  const auto id = s.given.id[s.part[b.first].grain];
  const std::string where = what + " lies within polygon " + std::to_string(id);
  if (s.step == 0) throw InputError(where + " before the first step; place the grains farther apart");
  throw CannotGoOn(where + " at step " + std::to_string(s.step) + "; stiffer contacts, rounder corners or a gentler load are needed");
}

}  // namespace arenite::dem
