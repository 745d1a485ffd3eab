#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "geometry/disk_window.hpp"
#include "texture/estimate.hpp"

namespace arenite::texture {

using Items = std::vector<std::size_t>;

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

/// Standard error of the mean of independent values; NaN for fewer than two.
double standard_error(const std::vector<double>& values);

/// Several statistics of the same items, with errors by leaving out one block at a time. `block_of` gives every
/// item's block; `periods` the period of a statistic that is an angle (0 or absent: none).
std::vector<Estimate> jackknife(const Items& items, const std::vector<int>& block_of,
                                const std::function<std::vector<double>(const Items&)>& statistics,
                                const std::vector<double>& periods = {});

/// The same for statistics that depend on sums over items only: `add(item, sums)` adds an item's terms to `terms`
/// sums. One pass over the items, whatever the number of blocks.
std::vector<Estimate> jackknife_of_sums(const Items& items, const std::vector<int>& block_of, std::size_t terms,
                                        const std::function<void(std::size_t, double*)>& add,
                                        const std::function<std::vector<double>(const std::vector<double>&)>& statistics,
                                        const std::vector<double>& periods = {});

/// Mean of one value an item.
Estimate mean(const Items& items, const std::vector<int>& block_of, const std::function<double(std::size_t)>& value);

}  // namespace arenite::texture
