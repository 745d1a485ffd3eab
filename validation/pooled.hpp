#pragma once
#include <string>
#include <vector>

#include "validation/results.hpp"
#include "validation/value.hpp"

namespace arenite::validation {

/// |<exp(i m theta)>| of the contact orientations of several runs together, with what as many random directions would
/// give.
struct PooledMode {
  double contacts = 0;
  Value amplitude, phase_deg;  ///< phase in [0, 360/m); errors from the scatter of seeds
  double noise = statistics::unknown;
  double noise_of_one = statistics::unknown;  ///< in one run of mean size
};
/// `set`: "" for all contacts, or "POM-POM", "strong", ...; runs without it are left out.
PooledMode pooled_mode(const std::vector<Run>& runs, const std::string& set, int m);

/// <cos m(theta - axis)> of the same: how far directions lie along the axis, negative where they lie between. Unlike an
/// amplitude it is not above zero for random directions; errors from the scatter of seeds.
Value pooled_along(const std::vector<Run>& runs, const std::string& set, int m, double axis_deg);

/// Smallest distance of two directions that repeat every `period` degrees.
double angle_between(double a_deg, double b_deg, double period);

/// The same of a mode's direction and another, with the error of the mode's.
Value angle_from(const PooledMode& mode, double wanted_deg, double period);

/// Means over the runs of each seed, then over seeds, with the standard error from the scatter of seeds: runs with one
/// seed share their packing.
Value mean_over_seeds(const std::vector<Run>& runs, const Number& number);
/// The same of the slope of y against x that each seed gives by itself; seeds with fewer than three points are left
/// out.
Value slope_over_seeds(const std::vector<Run>& runs, const Number& x, const Number& y);

/// A number in some runs over that in others of the same seed, minus 1: mean over seeds. Of one packing treated in two
/// ways.
Value paired_change(const std::vector<Run>& some, const std::vector<Run>& others, const Number& number);

/// How far a number rises from the least x to its greatest mean, and falls from there to the greatest x. Where the
/// greatest lies is found without the seed that is looked at, since the greatest of several noisy means lies above the
/// true ones.
struct Hump {
  Value rise, fall;
};
Hump hump_over_seeds(const std::vector<Run>& runs, const Number& x, const Number& y);

/// An exponential tail seen in several runs: means over seeds.
struct PooledTail {
  Value lead;      ///< ln L of the exponential less that of the half-Gaussian, of one run
  Value r2, beta;  ///< of the straight line through the logarithm of the share above; the exponential's
};
/// `name`: of the distribution, "sigma_norm.by_material.POM" or "force".
PooledTail pooled_tail(const std::vector<Run>& runs, const std::string& name);

}  // namespace arenite::validation
