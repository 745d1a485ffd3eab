#pragma once
#include <vector>

#include "statistics/histogram.hpp"
#include "statistics/numbers.hpp"
#include "statistics/tails.hpp"

namespace arenite::statistics {

/// f(x) = sqrt(beta)/C_q [1 + (q - 1) beta (x - mu)^2]^(-1/(q - 1)), a Gaussian for q = 1 (beta = 1/(2 variance)), with
/// power-law tails for 1 < q < 3 and of bounded support below 1 (P IV.A; Tsallis).
struct QGaussian {
  Estimate q, beta, centre;
  double r2 = unknown;
};
Numbers numbers(const QGaussian& fit);

/// The density above, q < 3, beta > 0.
double q_gaussian_density(double x, double centre, double beta, double q);

/// Least squares on the pdf, all bins alike (Levenberg-Marquardt from the pdf's peak): always the same path, no random
/// start. Errors by leaving out one block at a time (one Newton step from the fit to all); `replicate_mean` as in
/// fit_tail, by which beta and centre are set right. Unknown where there are fewer than 10 bins or where the best q
/// lies outside -2..2.95.
QGaussian fit_q_gaussian(const BlockCounts& counts, const std::vector<double>& replicate_mean);

}  // namespace arenite::statistics
