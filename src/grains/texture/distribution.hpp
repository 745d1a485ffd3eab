#pragma once
#include <vector>

#include "grains/texture/view.hpp"

namespace arenite::texture {

/// What a kind of values calls its mean and the share above it.
struct DistributionNames {
  const char *mean, *unit, *share, *mean_is, *share_is;
};

/// Numbers of one set of positive values (forces, stresses) over their own mean, x = F/<F>. `all` is the set that this
/// one is part of, `mean_of_all` its mean. `scale` turns the mean into its unit, NaN where that cannot be known;
/// `level` is View::level. All errors come from leaving out blocks of all, whatever the law: values of neighbours
/// depend on each other, and another sample has another mean.
Numbers distribution(const Items& items, const Items& all, const std::vector<int>& block_of,
                     const std::vector<double>& value, double mean_of_all, const DistributionNames& names,
                     double scale = 1, double level = 0);

}  // namespace arenite::texture
