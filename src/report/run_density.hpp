#pragma once
#include <string>
#include <vector>

#include "statistics/estimate.hpp"

namespace arenite::report {

/// Mean over runs of a density in their numbers, at the dotted `path`: {"low", "width", "density"} or {"x", "y"} with the middles
/// of bins, which all runs share, or {"edge", "density"} with bins of their own, which is then given in 40 bins of like width in
/// the logarithm. Errors are those of the mean. Empty if no run has it.
statistics::Curve mean_density(const std::vector<std::string>& numbers_json, const std::string& path);

/// The share above x of a density in bins of one width from 0 or elsewhere, at their lower edges; without errors.
statistics::Curve share_above(const statistics::Curve& density);

/// Mean over runs of the list at `path`, against that at `path_x`, or if this is empty against the middles of sectors of half a
/// turn, degrees, and over the mean of the whole list.
statistics::Curve mean_list(const std::vector<std::string>& numbers_json, const std::string& path_x, const std::string& path);

/// The number at that path, or the "value" of an estimate there; NaN if there is none.
double number_at(const std::string& numbers_json, const std::string& path);

/// Whether there is anything at that path.
bool has_numbers(const std::string& numbers_json, const std::string& path);

}  // namespace arenite::report
