#pragma once
#include <string>
#include <vector>

#include "statistics/estimate.hpp"

namespace arenite::report {

/// Mean over runs of a density in their numbers, at the dotted `path`: {"low", "width", "density"}, with bins that all runs
/// share, or {"edge", "density"} with bins of their own, which is then given in 40 bins of like width in the logarithm.
/// Errors are those of the mean. Empty if no run has it.
statistics::Curve mean_density(const std::vector<std::string>& numbers_json, const std::string& path);

}  // namespace arenite::report
