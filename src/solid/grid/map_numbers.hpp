#pragma once
#include "model/phase_map.hpp"
#include "model/voxel_map.hpp"
#include "solid/grid/cavities.hpp"
#include "statistics/numbers.hpp"

namespace arenite::grid {

/// Size, phases, S_m, grains, pores and voids of any map. Volumes of pores and voids are over pi reference_radius^2.
Numbers map_numbers(const PhaseMap& map, const CavityRules& rules, double reference_radius);

/// Radius of the disk whose area is that of so many nodes, in distances of neighbouring nodes.
double radius_over(double nodes);

/// Fractions of the volume by phase, and how many grains.
Numbers map_numbers(const VoxelMap& map);

}  // namespace arenite::grid
