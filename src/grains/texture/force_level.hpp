#pragma once
#include <cstddef>

#include "model/packing.hpp"
#include "statistics/estimate.hpp"

namespace arenite::texture {

/// Normal forces between grains in the whole sample: their mean, N, and the share of contacts above it.
struct ForceLevel {
  std::size_t contacts = 0;  ///< between grains
  statistics::Estimate mean, above_mean;
};

/// Errors by blocks of the sample. `number_error` is that of how many contacts there are, of which nobody but their
/// forces tells: one more or less is one that carries next to nothing. Means of fewer than two contacts are unknown.
ForceLevel force_level(const Packing& packing, double number_error = 0);

}  // namespace arenite::texture
