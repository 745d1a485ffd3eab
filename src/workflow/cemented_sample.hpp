#pragma once
#include <functional>
#include <string>

#include "model/packing.hpp"
#include "model/result.hpp"
#include "model/voxel_map.hpp"
#include "recipe/recipe.hpp"

namespace arenite::workflow {

/// Cements and rasterises a packing, with its phases, pores, voids and coordination as numbers. Throws InputError for a
/// saturation out of reach and a crop wider than the sample.
FieldResult make_cemented_sample(const recipe::Recipe& recipe, const Packing& packing);

/// The same of spheres: a cube from the middle of their container, cut into voxels. In a periodic cell that is as wide
/// everywhere the cube is the cell. What was made is told.
VoxelMap make_cemented_sample(const recipe::Recipe& recipe, const PackingIn<3>& packing,
                              const std::function<void(const std::string&)>& notice);

}  // namespace arenite::workflow
