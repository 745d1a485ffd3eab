#pragma once
#include "model/voxel_map.hpp"

namespace arenite::grid {

/// Labels the particles of a map: what faces join is one grain. Grains are numbered in the order of their first voxel.
void label_grains(VoxelMap& map);

/// One label for all particles of a map.
void label_alike(VoxelMap& map);

}  // namespace arenite::grid
