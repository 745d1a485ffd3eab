#pragma once
#include "model/sphere_pack.hpp"
#include "solid/cement/cement.hpp"

namespace arenite::cement {

/// The spheres whose images reach into the box of a pack, or have a surface within `gap` of one that does.
SpherePack with_images(const SpherePack& pack, double gap);

/// The matrix of spheres: none, full, coating, bridges, each a truncated cone of `width` times the radii, or menisci,
/// which end on circles of `width` times the smaller radius; `gap` is 0.075 mean radii unless given. A saturation asked
/// for is left to cemented_voxels.
SphereCement cement_spheres(const SpherePack& pack, const CementParameters& parameters);

}  // namespace arenite::cement
