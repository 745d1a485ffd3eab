#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "core/vec.hpp"
#include "geometry/ball.hpp"
#include "geometry/rectangle.hpp"

namespace arenite::texture {

/// An upright part of the plane or of space.
template <int D> using Region = std::conditional_t<D == 2, geometry::Rectangle, geometry::Box<3>>;

inline Vec2 low_of(const geometry::Rectangle& region) { return {region.x_min, region.y_min}; }
inline Vec3 low_of(const geometry::Box<3>& region) { return region.corner; }
inline Vec2 high_of(const geometry::Rectangle& region) { return {region.x_max, region.y_max}; }
inline Vec3 high_of(const geometry::Box<3>& region) { return region.end(); }
inline Vec2 size_of(const geometry::Rectangle& region) { return {region.width(), region.height()}; }
inline Vec3 size_of(const geometry::Box<3>& region) { return region.size; }

/// From its lowest corner.
inline geometry::Rectangle region_from(Vec2 corner, Vec2 size) {
  return {corner.x, corner.x + size.x, corner.y, corner.y + size.y};
}
inline geometry::Box<3> region_from(Vec3 corner, Vec3 size) { return {corner, size}; }

/// One of the equal parts of a region, of which so many stand along each side.
inline geometry::Rectangle part_of(const geometry::Rectangle& region, int per_side, const std::array<int, 2>& index) {
  const double w = region.width() / per_side, h = region.height() / per_side;
  const auto [column, row] = index;
  return {region.x_min + column * w, region.x_min + (column + 1) * w, region.y_min + row * h,
          region.y_min + (row + 1) * h};
}
inline geometry::Box<3> part_of(const geometry::Box<3>& region, int per_side, const std::array<int, 3>& index) {
  const Vec3 size = region.size / per_side;
  return {region.corner + by_axis<3>([&](int axis) { return index[static_cast<std::size_t>(axis)] * size[axis]; }),
          size};
}

/// A region cut into equal blocks, as many along each side. Neighbouring grains and contacts are not independent, so
/// errors come from the scatter between blocks, not between grains.
template <int D> struct BlockGridIn {
  Region<D> bounds;
  int per_side = 1;

  int count() const {
    int all = 1;
    for (int axis = 0; axis < D; ++axis) all *= per_side;
    return all;
  }
  /// Points outside belong to the nearest block.
  int block_of(Vec<D> p) const {
    const Vec<D> low = low_of(bounds), size = size_of(bounds);
    int block = 0;
    for (int axis = D - 1; axis >= 0; --axis) {
      const double share = size[axis] > 0 ? (p[axis] - low[axis]) / size[axis] : 0;
      block = block * per_side + static_cast<int>(std::clamp(std::floor(share * per_side), 0.0, per_side - 1.0));
    }
    return block;
  }
  /// That of an item there; where the region is too small to be cut every item is its own.
  int block_of(Vec<D> p, std::size_t item) const { return per_side > 1 ? block_of(p) : static_cast<int>(item); }
  Region<D> block(int b) const {
    std::array<int, D> index{};
    for (int& along : index) along = b % per_side, b /= per_side;
    return part_of(bounds, per_side, index);
  }
};
using BlockGrid = BlockGridIn<2>;

/// Blocks of about a dozen grains or more, 6 x 6 or 4 x 4 x 4 at most; 1 for a sample too small to be cut.
template <int D = 2> int blocks_per_side(std::size_t grains) {
  constexpr std::array most{6, 4};
  return std::clamp(static_cast<int>(geometry::side_of_cube<D>(static_cast<double>(grains) / 12)), 1, most[D - 2]);
}

}  // namespace arenite::texture
