#pragma once
#include "model/phase_map.hpp"
#include "model/voxel_map.hpp"

namespace arenite::grid {

/// Longest of the voids that are at most `most` nodes across, as a crack is: how far it reaches along an axis, in
/// nodes; 0 where there is none. A void node is of one if solid lies on both sides of it, along an axis or a diagonal,
/// with so few void nodes between; those that touch, at corners too, are one.
int longest_thin_void(const PhaseMap& map, int most);
int longest_thin_void(const VoxelMap& map, int most);

}  // namespace arenite::grid
