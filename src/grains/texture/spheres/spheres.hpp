#pragma once
#include "grains/texture/texture.hpp"
#include "grains/texture/view.hpp"
#include "model/measuring.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"
#include "statistics/numbers.hpp"

namespace arenite::texture {

/// Those that suit a sample whose recipe is not known: friction is what its forces show.
SphereOptions sphere_options(const PackingIn<3>& packing, const Measuring& how);

/// Those that suit a stage: without friction it takes four contacts to hold a sphere, with friction two.
SphereOptions sphere_options(const Asked& asked);

/// Solid fraction, also of growing windows, coordination, fabric, stress, forces and grain stresses of a sample of
/// spheres as `measure` finds them, under the names that samples of the plane have, each with its error and meaning,
/// with its notes.
Numbers measure_spheres(const PackingIn<3>& packing, const SphereOptions& options = {});

}  // namespace arenite::texture
