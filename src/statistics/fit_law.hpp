#pragma once
#include <cmath>
#include <functional>
#include <vector>

#include "statistics/estimate.hpp"

namespace arenite::statistics {

/// y at x for such parameters.
using Law = std::function<double(double x, const std::vector<double>& parameters)>;

/// The parameters for which a law lies nearest to points by least squares, weighted by the points' errors, found from
/// `start` (K. Levenberg, Q. Appl. Math. 2, 164, 1944; D. W. Marquardt, J. SIAM 11, 431, 1963), and their standard
/// errors, which are larger where points scatter more than their errors. Errors that are not known (0, or not a number)
/// are the largest of those that are; without any all points count alike, and their scatter tells. Throws InputError
/// for lists of unlike lengths, numbers that are not finite, errors below 0 and fewer points than parameters.
std::vector<Estimate> fit_law(const Law& law, std::vector<double> start, const std::vector<double>& x,
                              const std::vector<double>& y, const std::vector<double>& error);

/// y = factor x^exponent.
struct PowerLaw {
  Estimate factor, exponent;
  double at(double x) const { return factor.value * std::pow(x, exponent.value); }
};
/// Likewise, of points above 0 at two places at least.
PowerLaw fit_power(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& error);

}  // namespace arenite::statistics
