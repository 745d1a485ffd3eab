#include "grains/texture/blocks.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::texture {

int BlockGrid::block_of(Vec2 p) const {
  const auto along = [&](double x, double low, double width) {
    const double share = width > 0 ? (x - low) / width : 0;
    return static_cast<int>(std::clamp(std::floor(share * per_side), 0.0, per_side - 1.0));
  };
  return along(p.y, bounds.y_min, bounds.height()) * per_side + along(p.x, bounds.x_min, bounds.width());
}

geometry::Rectangle BlockGrid::block(int b) const {
  const double w = bounds.width() / per_side, h = bounds.height() / per_side;
  const int column = b % per_side, row = b / per_side;
  return {bounds.x_min + column * w, bounds.x_min + (column + 1) * w, bounds.y_min + row * h, bounds.y_min + (row + 1) * h};
}

int blocks_per_side(std::size_t grains) {
  return std::clamp(static_cast<int>(std::sqrt(static_cast<double>(grains) / 12)), 1, 6);
}

}  // namespace arenite::texture
