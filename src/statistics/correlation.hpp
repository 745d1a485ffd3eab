#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "statistics/estimate.hpp"

namespace arenite::statistics {

/// Means of x and y, and sums of squares and products about them.
struct SecondMoments {
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, yy = 0;
};
SecondMoments second_moments(const std::vector<double>& x, const std::vector<double>& y);

/// y = intercept + slope x by least squares, all points alike, with the standard errors of independent points.
struct Line {
  double slope = unknown, slope_error = unknown, r2 = unknown;
  double intercept = unknown, intercept_error = unknown;
};

/// Unknown for fewer than three points, and where x or y does not vary.
Line fit_line(const std::vector<double>& x, const std::vector<double>& y);

/// Ranks from 1; equal values share the mean of theirs.
std::vector<double> ranks(const std::vector<double>& values);

/// Pearson's coefficient of correlation; NaN where one of the two does not vary or there are fewer than two pairs.
double pearson(const std::vector<double>& x, const std::vector<double>& y);

/// Spearman's: Pearson's of the ranks.
double spearman(const std::vector<double>& x, const std::vector<double>& y);

/// Mean of the values that are known and, where `counts` is given, stand beside a 1; unknown without any.
double mean_of_known(const std::vector<double>& values, const std::vector<std::uint8_t>& counts = {});
/// Each value over a mean; what is not known stays so, and all is unknown over a mean of zero.
std::vector<double> over(std::vector<double> values, double mean);
/// Over that of the known ones.
std::vector<double> over_mean(const std::vector<double>& values);

/// Root mean square of x - y, which are as many.
double rms_difference(const std::vector<double>& x, const std::vector<double>& y);

/// How y goes with x over independent samples, one a row: variance in large grains against the deviation of pores, say.
struct Relation {
  std::size_t count = 0;       ///< rows in which both are known
  Estimate pearson, spearman;  ///< errors by leaving out one row at a time
  Line line;                   ///< y = intercept + slope x
};

/// Rows where x or y is not finite are left out. Throws InputError where x and y differ in length.
Relation relate(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace arenite::statistics
