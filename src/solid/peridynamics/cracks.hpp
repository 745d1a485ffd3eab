#pragma once
#include <vector>

#include "model/result.hpp"
#include "model/voxel_map.hpp"
#include "solid/peridynamics/failure_state.hpp"

/// Where a test to failure broke a sample.
namespace arenite::peridynamics {

/// Broken bonds as cracks: their middles, m from the lower left corner of the map.
std::vector<Crack> cracks_of(const std::vector<BrokenBond>& broken, double dx);
/// The same in space, of bonds with this horizon.
std::vector<SpaceCrack> space_cracks_of(const std::vector<BrokenBond>& broken, int horizon, double dx);

/// The share of the bonds of every voxel that have broken, in the map's order; 0 in the void.
std::vector<float> damage_of(const VoxelMap& map, const std::vector<BrokenBond>& broken, int horizon);

}  // namespace arenite::peridynamics
