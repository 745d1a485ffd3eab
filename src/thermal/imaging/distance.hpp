#pragma once
#include <cstdint>
#include <vector>

#include "model/phase_map.hpp"

/// Grains in pictures.
namespace arenite::imaging {

/// Squared distance, in nodes, from each particle node to the nearest node that is none; 0 where there is no particle.
/// Exact (A. Meijster, J. Roerdink, W. Hesselink, 2000). What lies outside the map is not known and does not count; a
/// map without any other phase has the largest number everywhere.
std::vector<std::int32_t> squared_distance(const PhaseMap& map);

}  // namespace arenite::imaging
