#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/vec.hpp"
#include "geometry/rectangle.hpp"

namespace arenite::texture {

/// A rectangle cut into k x k equal blocks. Neighbouring grains and contacts are not independent, so errors come from
/// the scatter between blocks, not between grains.
struct BlockGrid {
  geometry::Rectangle bounds;
  int per_side = 1;

  int count() const { return per_side * per_side; }
  /// Points outside belong to the nearest block.
  int block_of(Vec2 p) const {
    const auto along = [&](double x, double low, double width) {
      const double share = width > 0 ? (x - low) / width : 0;
      return static_cast<int>(std::clamp(std::floor(share * per_side), 0.0, per_side - 1.0));
    };
    return along(p.y, bounds.y_min, bounds.height()) * per_side + along(p.x, bounds.x_min, bounds.width());
  }
  /// That of an item there; where the rectangle is too small to be cut every item is its own.
  int block_of(Vec2 p, std::size_t item) const { return per_side > 1 ? block_of(p) : static_cast<int>(item); }
  geometry::Rectangle block(int b) const {
    const double w = bounds.width() / per_side, h = bounds.height() / per_side;
    const int column = b % per_side, row = b / per_side;
    return {bounds.x_min + column * w, bounds.x_min + (column + 1) * w, bounds.y_min + row * h,
            bounds.y_min + (row + 1) * h};
  }
};

/// Blocks of about a dozen grains or more, 6 x 6 at most; 1 for a sample too small to be cut.
inline int blocks_per_side(std::size_t grains) {
  return std::clamp(static_cast<int>(std::sqrt(static_cast<double>(grains) / 12)), 1, 6);
}

}  // namespace arenite::texture
