#pragma once
#include <limits>
#include <utility>
#include <vector>

#include "statistics/estimate.hpp"

namespace arenite::statistics {

/// A measured quantity: value, standard error (NaN: not known), and the degrees of freedom that the error was found
/// with (infinite: the error is known for certain).
struct Measured {
  double value = unknown, error = unknown;
  double freedom = std::numeric_limits<double>::infinity();
};

/// Ends of an interval that covers the true value in 95 of 100 cases, by Student's t; NaN where the error is not known.
struct Interval {
  double low = unknown, high = unknown;
};
Interval confidence_95(const Measured& m);

/// Mean of values alike, its standard error from their scatter, n - 1 degrees of freedom. One value has no error.
Measured mean_of(const std::vector<double>& values);
/// Of angles that are the same again after `period`, in [0, period): each is taken the shorter way from the direction
/// of all of them as vectors.
Measured mean_of_angles(std::vector<double> values, double period);

/// Product of independent quantities to powers: relative errors add in squares, degrees of freedom after Welch and
/// Satterthwaite. Quantities whose error is not known add none; if that holds for all, the product's is not known.
Measured product(const std::vector<std::pair<Measured, double>>& factors);

/// How often groups that are alike would have means as far apart as these (analysis of variance), NaN where fewer than
/// two groups or no scatter tell.
double chance_of_equal_means(const std::vector<std::vector<double>>& groups);

/// Share of Student's t distribution below t. `freedom` > 0 need not be whole; infinity gives the normal distribution.
double student_share(double t, double freedom);

/// The t below which the share p lies, p in (0, 1).
double student_quantile(double p, double freedom);

/// Survival function of Fisher's F distribution: how often groups that are alike differ as much.
double fisher_survival(double f, double freedom_between, double freedom_within);

}  // namespace arenite::statistics
