#pragma once
#include <cstddef>
#include <vector>

#include "statistics/estimate.hpp"
#include "statistics/line.hpp"

namespace arenite::statistics {

/// Ranks from 1; equal values share the mean of theirs.
std::vector<double> ranks(const std::vector<double>& values);

/// Pearson's coefficient of correlation; NaN where one of the two does not vary or there are fewer than two pairs.
double pearson(const std::vector<double>& x, const std::vector<double>& y);

/// Spearman's: Pearson's of the ranks.
double spearman(const std::vector<double>& x, const std::vector<double>& y);

/// How y goes with x over independent samples, one a row: variance in large grains against the deviation of pores, say.
struct Relation {
  std::size_t count = 0;             ///< rows in which both are known
  Estimate pearson, spearman;        ///< errors by leaving out one row at a time
  Line line;                         ///< y = intercept + slope x
};

/// Rows where x or y is not finite are left out. Throws InputError where x and y differ in length.
Relation relate(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace arenite::statistics
