#pragma once
#include <string>
#include <vector>

#include "statistics/estimate.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {

/// The exponential tail k exp(-s x) of a mean density, as a line from one end of the fitted range to the other. Slope s and range
/// are means over runs of {"slope", "low", "high"} in their numbers, at the dotted `path`; k is what fits the density best in its
/// logarithm between the ends. Where there is {"beta_line"} instead, the straight line of regression of ln P on x beyond the mean,
/// P the share above x. Empty if no run has a tail there or the density has no point in it.
statistics::Curve tail_line(const std::vector<Numbers>& runs, const std::string& path, const statistics::Curve& density);

}  // namespace arenite::report
