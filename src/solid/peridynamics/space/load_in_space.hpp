#pragma once
#include "model/voxel_map.hpp"
#include "solid/peridynamics/options.hpp"
#include "solid/statics/loading.hpp"

namespace arenite::peridynamics {

/// Loads a sample in space by bonds between the middles of its voxels: the top layer of voxels is moved against the
/// lowest one. Bonds do not break; of the options those of the static solve count. Throws InputError for a map or
/// options that make no sense; anything that a sound map can turn out to be is an Ending.
statics::LoadResultIn<3> load(const VoxelMap& map, const LoadOptions& options);

/// Whether the lowest and the highest layer of a map are joined by bonds through voids alone: by no chain of voxels of
/// solid that meet in a face, an edge or a corner.
bool joined_through_voids_only(const VoxelMap& map);

}  // namespace arenite::peridynamics
