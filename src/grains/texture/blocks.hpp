#pragma once
#include "geometry/disk_window.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::texture {

using statistics::Items;
using statistics::jackknife;
using statistics::jackknife_of_sums;
using statistics::mean;
using statistics::standard_error;

/// A rectangle cut into k x k equal blocks. Neighbouring grains and contacts are not independent, so errors come from
/// the scatter between blocks, not between grains.
struct BlockGrid {
  geometry::Rectangle bounds;
  int per_side = 1;

  int count() const { return per_side * per_side; }
  int block_of(Vec2 p) const;                  ///< points outside belong to the nearest block
  geometry::Rectangle block(int b) const;
};

/// Blocks of about a dozen grains or more, 6 x 6 at most; 1 for a sample too small to be cut.
int blocks_per_side(std::size_t grains);

}  // namespace arenite::texture
