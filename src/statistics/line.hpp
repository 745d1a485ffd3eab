#pragma once
#include <vector>

#include "statistics/estimate.hpp"

namespace arenite::statistics {

/// y = intercept + slope x by least squares, all points alike, with the standard errors of independent points.
struct Line {
  double slope = unknown, slope_error = unknown, r2 = unknown;
  double intercept = unknown, intercept_error = unknown;
};

/// Unknown for fewer than three points, and where x or y does not vary.
Line fit_line(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace arenite::statistics
