#pragma once
#include <cstdint>
#include <optional>

#include "model/domain.hpp"
#include "model/grains.hpp"

namespace arenite::packing {

/// A glued region: grains whose centre lies inside are in zone 1.
struct Region {
  enum class Shape { circle, rectangle };
  Shape shape = Shape::circle;
  double x = 0, y = 0;                 ///< centre, m from the frame's lower left corner
  double radius = 0;                   ///< circle
  double width = 0, height = 0;        ///< rectangle
  std::optional<std::int64_t> count;   ///< the nearest grains to (x, y), that many, instead of a shape
  bool operator==(const Region&) const = default;
};

/// Puts the grains of the region into zone 1, all others into zone 0; returns how many are in it.
std::int64_t mark_region(Grains& grains, const Domain& domain, const Region& region);

}  // namespace arenite::packing
