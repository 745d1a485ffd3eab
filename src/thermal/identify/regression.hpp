#pragma once
#include <vector>

#include "statistics/measured.hpp"

namespace arenite::identify {

/// A straight line through measured points.
struct Regression {
  statistics::Measured slope, intercept;  ///< the intercept is 0 and without error where the line was held to the origin
  double r2 = statistics::unknown;        ///< share of the variance of y that the line takes (about 0 if held to the origin)
  double correlation = 0;                 ///< of neighbouring residuals, 0 where it is not taken into account
};

/// y = intercept + slope x by least squares, y alone in error. Records are often sampled more densely than their noise
/// changes: from 10 points on, a positive correlation r of neighbouring residuals widens the errors by
/// sqrt((1 + r)/(1 - r)) and takes degrees of freedom by the same share, as for a first-order autoregressive noise.
/// Needs three points (two through the origin) and an x that varies; otherwise all is unknown.
Regression regress(const std::vector<double>& x, const std::vector<double>& y, bool through_origin = false);

}  // namespace arenite::identify
