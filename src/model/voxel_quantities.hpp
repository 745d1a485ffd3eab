#pragma once
#include <cstddef>
#include <string_view>
#include <vector>

#include "model/voxel_map.hpp"

namespace arenite {

/// A number that every voxel of a loaded sample has, and that pictures of it are painted by.
struct VoxelQuantity {
  std::string_view id, name;  ///< "zz", as it is chosen on the page; "sigma_zz", as in files and Python
  std::string_view words, symbol, unit;
  bool is_magnitude = false;  ///< never below 0, so that no scale is centred
  double (*of)(const VoxelStress& field, std::size_t voxel);
};

/// All, the stress along the axis of the clamps first; a new one is one more row.
const std::vector<VoxelQuantity>& voxel_quantities();

}  // namespace arenite
