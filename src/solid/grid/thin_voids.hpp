#pragma once
#include "model/phase_map.hpp"
#include "model/voxel_map.hpp"

namespace arenite::grid {

/// Longest of the voids that are at most `most` nodes across, as a crack is, in nodes; 0 where there is none. A void
/// node is of one if solid lies on both sides of it, along an axis or a diagonal, with so few void nodes between; those
/// that touch, at corners too, are one. It is as long as it reaches along an axis or, where it opens into wider voids,
/// as it is deep from there: a wedge beside a contact of grains is short, however many of them hang together.
int longest_thin_void(const PhaseMap& map, int most);
int longest_thin_void(const VoxelMap& map, int most);

}  // namespace arenite::grid
