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
  const double width = s.domain.width(), height = s.domain.height();
  const int up = s.domain.periodic_y ? 1 : 0, across = s.domain.periodic_x ? 1 : 0;
  for (int iy = 0; iy <= up; ++iy)
    for (int ix = iy == 0 ? 1 : -across; ix <= across; ++ix)
      for (std::size_t k = 0; k < s.count; ++k) {
        const double x = s.record[k].x + ix * width + iy * s.domain.tilt, y = s.record[k].y + iy * height;
        const bool near_x = !s.domain.periodic_x || (x > w[left].position - reach && x < w[right].position + reach);
        if (near_x && y < w[top].position + reach) s.ghost.push_back({static_cast<std::int32_t>(k), ix, iy});
      }
  s.record.resize(s.count + s.ghost.size());
  refresh_ghosts(s);
}

void refresh_ghosts(Sample& s) {
  const double width = s.domain.width(), height = s.domain.height();
  const double stretch_x = s.domain.periodic_x ? s.domain.wall[right].velocity - s.domain.wall[left].velocity : 0;
  const double stretch_y = s.domain.periodic_y ? s.domain.wall[top].velocity - s.domain.wall[bottom].velocity : 0;
  for (std::size_t g = 0; g < s.ghost.size() - s.foot.size(); ++g) {
    const Ghost& ghost = s.ghost[g];
    DiskRecord& d = s.record[s.count + g];
    d = s.record[static_cast<std::size_t>(ghost.source)];
    d.x += ghost.shift_x * width + ghost.shift_y * s.domain.tilt;
    d.y += ghost.shift_y * height;
    d.vx += ghost.shift_x * stretch_x + ghost.shift_y * (s.domain.tilt * stretch_x / width + s.shear_rate * height);
    d.vy += ghost.shift_y * stretch_y;
  }
  refresh_feet(s);
}

}  // namespace arenite::dem
