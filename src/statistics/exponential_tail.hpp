#pragma once
#include <cstddef>
#include <vector>

#include "statistics/estimate.hpp"

namespace arenite::statistics {

/// Exponential tail beyond the mean, x > 1: P = P_0 exp(beta (1 - x)).
struct ExponentialTail {
  std::size_t count = 0;
  Estimate beta;                       ///< maximum likelihood; error beta/sqrt(n)
  Estimate line_beta;                  ///< straight line through ln of the cumulative
  double line_r2 = unknown;
  double likelihood_ratio = unknown;   ///< ln L(exponential) - ln L(half-Gaussian)
  double p_value = unknown;            ///< that the exponential's lead is chance (Vuong's test, one-sided)
};

/// Exponential tail of x beyond 1: maximum likelihood, straight line through ln of the cumulative, and the likelihood
/// ratio against a half-Gaussian (Vuong's test). `sorted` rises; shares refer to all of its values.
ExponentialTail exponential_tail(const std::vector<double>& sorted);

}  // namespace arenite::statistics
