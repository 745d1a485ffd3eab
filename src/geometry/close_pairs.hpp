#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/rectangle.hpp"

namespace arenite::geometry {

/// The smallest box around points; of no size without any.
template <int D> Box<D> around(std::span<const Vec<D>> points) {
  if (points.empty()) return {};
  Vec<D> low = points[0], high = points[0];
  for (const Vec<D>& p : points)
    for (int axis = 0; axis < D; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  return {low, high - low};
}

struct Pair {
  std::int32_t i, j;  ///< i < j
};

/// Every pair of disks (D = 2) or spheres (3) whose surface gap (nearest image) is at most `gap`, sorted by (i, j).
/// Cells are as wide as the largest one plus the gap, so the cost is linear in their number unless sizes differ by
/// orders. InputError for more than a million pairs and 256 a disk: so many neighbours have only disks whose radii are
/// in another unit.
template <int D>
std::vector<Pair> close_pairs(std::span<const Vec<D>> centre, std::span<const double> radius, const Box<D>& box,
                              double gap);

inline std::vector<Pair> close_pairs(const std::vector<Vec2>& centre, std::span<const double> radius, const Box<2>& box,
                                     double gap) {
  return close_pairs<2>(std::span(centre), radius, box, gap);
}

}  // namespace arenite::geometry
