#pragma once
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "geometry/rectangle.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// The core of a polygon, the convex polygon of its corners' centres, in one periodic image: where its corners are, m.
struct Core {
  std::int32_t body = 0;
  Cells shift;
  Vec2 middle;
  double reach = 0;  ///< of its widened rim from the middle
  std::vector<Vec2> corner;
};

/// The corner where its body's own image is, from the record.
Vec2 corner_of(const Sample& sample, std::size_t disk);

/// Radius of a polygon's corners, m.
double rounding_of(const Sample& sample, std::int32_t body);

/// The farthest that the rim of a polygon is from the middle of its core, m; 0 where there are no polygons.
double largest_core(const Sample& sample);

/// Every polygon, and its images where their middles come as near to the cell as `reach`, m.
std::vector<Core> all_cores(const Sample& sample, double reach);

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
[[noreturn]] void refuse_inside(const Sample& sample, const std::string& what, const Core& core);

}  // namespace arenite::dem
