#pragma once
#include "geometry/label_cells.hpp"
#include "model/voxel_map.hpp"

namespace arenite::grid {

/// Labels the particles of a map: what faces join is one grain, or that cut at its necks. Grains are numbered in the
/// order of their first voxel; of a periodic map they go on across its faces. Throws InputError for a smoothing that is
/// negative or no number.
void label_grains(VoxelMap& map, const geometry::LabelOptions& options = {}, bool periodic = false);

/// One label for all particles of a map.
void label_alike(VoxelMap& map);

/// Leaves out the grains that own no voxel, and numbers the others on.
void drop_absent_grains(VoxelMap& map);

}  // namespace arenite::grid
