#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/rectangle.hpp"

namespace arenite::geometry {

struct Pair {
  std::int32_t i, j;  ///< i < j
};

/// Every pair of disks whose surface gap (nearest image) is at most `gap`, sorted by (i, j). Cells are as wide as the largest disk plus the gap, so
/// the cost is linear in the number of disks unless sizes differ by orders. InputError for more than a million pairs and 256 a disk: so many
/// neighbours have only disks whose radii are in another unit.
std::vector<Pair> close_pairs(std::span<const double> x, std::span<const double> y, std::span<const double> radius, const Box& box, double gap);

}  // namespace arenite::geometry
