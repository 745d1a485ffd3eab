#pragma once
#include <string>
#include <vector>

#include "model/voxel_map.hpp"
#include "statistics/numbers.hpp"

namespace arenite::stress {

/// How statistics of voxels are taken.
struct VoxelStressOptions {
  int clamp_layers = 4;  ///< left out at the lowest and the highest face
  int blocks = 4;        ///< a side: errors come from blocks^3 blocks
  bool shear = false;    ///< of sigma_xz, otherwise of sigma_zz
};

/// Statistics of the stress along the load by set, as in the plane (stress/component_statistics.hpp). Throws
/// InputError where the layers left out leave none.
Numbers measure(const VoxelMap& map, const VoxelStress& field, const VoxelStressOptions& options,
                std::vector<std::string>& notes);

}  // namespace arenite::stress
