#pragma once
#include <vector>

#include "grains/texture/blocks.hpp"
#include "grains/texture/texture.hpp"

namespace arenite::texture {

using statistics::exponential_tail;

/// Power law k x^-alpha of 0 < x < 1 by maximum likelihood.
PowerLaw weak_power_law(const std::vector<double>& sorted);

/// Statistics of `value` over the items, each over their mean. `mean_of_all` is the mean of the set that this one is
/// part of. `scale` turns the mean into its unit, NaN where that cannot be known.
Distribution distribution(const Items& items, const std::vector<int>& block_of, const std::vector<double>& value,
                          double mean_of_all, double scale = 1);

}  // namespace arenite::texture
