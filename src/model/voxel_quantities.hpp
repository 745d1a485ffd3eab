#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "model/result.hpp"
#include "model/voxel_map.hpp"

namespace arenite {

/// A number that every voxel of a loaded sample has, and that pictures of it are painted by.
struct VoxelQuantity {
  std::string_view id, name;  ///< "zz", as it is chosen on the page; "sigma_zz", as in files and Python
  std::string_view words, symbol, unit;
  bool is_magnitude = false;  ///< never below 0, so that no scale is centred
  double (*of)(const VoxelStress& field, std::size_t voxel);
  enum class Acts : std::uint8_t { no_load, along_clamps, shear } by = Acts::no_load;  ///< what acts by this component
  bool (*is_known)(const VoxelStress& field) = nullptr;  ///< in which fields; in all, if null
};

/// All, the stress along the axis of the clamps first; a new one is one more row.
const std::vector<VoxelQuantity>& voxel_quantities();

/// Those that a sample has.
std::vector<const VoxelQuantity*> quantities_of(const VoxelResult& sample);

/// What is drawn of a loaded sample: the component of stress that its load acts by, then those that are no component,
/// then where it broke.
std::vector<const VoxelQuantity*> quantities_drawn(const VoxelResult& sample);

}  // namespace arenite
