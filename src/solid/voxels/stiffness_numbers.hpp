#pragma once
#include "solid/voxels/load.hpp"
#include "statistics/numbers.hpp"

namespace arenite::voxels {

/// Voxels that carry, hang on one clamp, or float.
Numbers support_numbers(const statics::Support& support);

/// The stiffness, its Young's moduli, Poisson's ratios and shear moduli along the axes, the bounds of Voigt and Reuss,
/// and how isotropic it is.
Numbers stiffness_numbers(const EffectiveStiffness& effective);

}  // namespace arenite::voxels
