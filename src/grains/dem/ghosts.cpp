#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {

/// Images to the right and above only: every pair across an edge then occurs once, as (disk, ghost).
void make_ghosts(Sample& s) {
  s.ghost.clear();
  s.foot.clear();
  s.point_foot.clear();
  s.record.resize(s.count);
  const double reach = reach_of(s);
  const auto& w = s.domain.wall;
  const int up = s.domain.periodic_y ? 1 : 0, across = s.domain.periodic_x ? 1 : 0;
  for (int iy = 0; iy <= up; ++iy)
    for (int ix = iy == 0 ? 1 : -across; ix <= across; ++ix)
      for (std::size_t k = 0; k < s.count; ++k) {
        const double x = s.record[k].place.x + ix * s.domain.width() + iy * s.domain.tilt, y = s.record[k].place.y + iy * s.domain.height();
        const bool near_x = !s.domain.periodic_x || (x > w[left].position - reach && x < w[right].position + reach);
        if (near_x && y < w[top].position + reach) s.ghost.push_back({static_cast<std::int32_t>(k), {ix, iy}});
      }
  s.record.resize(s.count + s.ghost.size());
  refresh_ghosts(s);
}

void refresh_ghosts(Sample& s) {
  for (std::size_t g = 0; g < s.ghost.size() - s.foot.size(); ++g) {
    DiskRecord& d = s.record[s.count + g];
    d = s.record[s.ghost[g].source];
    d.place += image_place(s, s.ghost[g].shift);
    d.velocity += image_velocity(s, s.ghost[g].shift);
  }
  refresh_feet(s);
}

}  // namespace arenite::dem
