#pragma once
#include <vector>

#include "grains/texture/rev.hpp"
#include "model/measuring.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"
#include "statistics/numbers.hpp"

namespace arenite::texture {

/// Choices that the definitions leave open for samples in space.
struct SphereOptions : Measuring {
  int rattler_contacts = 4;  ///< a sphere with fewer force-bearing contacts than this is a rattler
  Vec3 load_direction = {};  ///< where load_axis does not give it: a unit vector; 0: that of greatest compression
  Vec3 gravity = {};         ///< m/s^2; for the balance of spheres and walls only
  RevWindows rev = {};
};

/// Those that suit a sample whose recipe is not known: friction is what its forces show.
SphereOptions sphere_options(const PackingIn<3>& packing, const Measuring& how);

/// Those that suit a stage: without friction it takes four contacts to hold a sphere, with friction two.
SphereOptions sphere_options(const Asked& asked);

/// Solid fraction, also of growing windows, coordination, fabric, stress, forces and grain stresses of a sample of
/// spheres, under the names that samples of the plane have, each with its error and meaning. Contacts of which none has
/// a force are those of a sample whose forces nobody knows; a container without walls and periodic sides is none, but
/// the smallest box around the spheres: what needs them is left out, and "notes" say so. Throws InputError for a
/// container without volume.
Numbers measure_spheres(const PackingIn<3>& packing, const SphereOptions& options = {});

/// Mean stress of each sphere over its mean over those that are measured; 0 where no force acts.
std::vector<double> stresses_over_mean(const PackingIn<3>& packing, const SphereOptions& options);

}  // namespace arenite::texture
