#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "statistics/estimate.hpp"

namespace arenite::statistics {

using Items = std::vector<std::size_t>;

/// Standard error of the mean of independent values; NaN for fewer than two.
double standard_error(const std::vector<double>& values);

/// Errors of several statistics (`values`) from their values with one block left out each: one row a block. Neighbours
/// are not independent, so errors come from the scatter between blocks. `periods` gives the period of a statistic that
/// is an angle (0 or absent: none).
std::vector<Estimate> with_errors(const std::vector<double>& values, const std::vector<std::vector<double>>& replicates,
                                  const std::vector<double>& periods = {});

/// Several statistics of the same items, with errors by leaving out one block at a time. `block_of` gives every item's
/// block; `periods` the period of a statistic that is an angle (0 or absent: none).
std::vector<Estimate> jackknife(const Items& items, const std::vector<int>& block_of,
                                const std::function<std::vector<double>(const Items&)>& statistics,
                                const std::vector<double>& periods = {});

/// The same for statistics that depend on sums over items only: `add(item, sums)` adds an item's terms to `terms` sums.
/// One pass over the items, whatever the number of blocks.
std::vector<Estimate> jackknife_of_sums(
    const Items& items, const std::vector<int>& block_of, std::size_t terms,
    const std::function<void(std::size_t, double*)>& add,
    const std::function<std::vector<double>(const std::vector<double>&)>& statistics,
    const std::vector<double>& periods = {});

/// Mean of one value an item.
Estimate mean(const Items& items, const std::vector<int>& block_of, const std::function<double(std::size_t)>& value);

}  // namespace arenite::statistics
