#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/random.hpp"
#include "statistics/histogram.hpp"

namespace arenite::statistics {

/// n independent values of `draw(random)`, dealt out to the blocks in turn.
template <class Draw> BlockedSample drawn(std::size_t n, std::uint64_t seed, Draw&& draw, int blocks = 36) {
  RandomStream random(seed, Purpose::test);
  BlockedSample sample{{}, {}, blocks};
  for (std::size_t k = 0; k < n; ++k) {
    sample.x.push_back(draw(random));
    sample.block.push_back(static_cast<std::uint16_t>(k % static_cast<std::size_t>(blocks)));
  }
  return sample;
}

/// Counts in the bins that the sample itself asks for.
inline BlockCounts counted(const BlockedSample& sample) {
  const auto q = exact_quantiles(sample.x, {0, 1e-4, 0.25, 0.75, 0.9999, 1});
  return count(sample, pdf_bins(sample.x.size(), {q[0], q[1], q[2], q[3], q[4], q[5]}));
}

/// A q-Gaussian about 0 by the generalised Box-Muller method: beta = 1/(3 - q).
inline double draw_q_gaussian(RandomStream& random, double q) {
  const double u = 1 - random.uniform(), angle = 2 * std::numbers::pi * random.uniform(), p = (1 + q) / (3 - q);
  const double log_p = std::abs(p - 1) < 1e-12 ? std::log(u) : (std::pow(u, 1 - p) - 1) / (1 - p);
  return std::sqrt(-2 * log_p) * std::cos(angle);
}

}  // namespace arenite::statistics
