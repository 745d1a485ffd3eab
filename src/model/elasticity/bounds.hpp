#pragma once
#include <vector>

namespace arenite::elasticity {

/// A phase of a mixture: its share of the area and its modulus, Pa (0: void).
struct Share {
  double area = 0, young = 0;
};

/// Bounds of Young's modulus of a plane mixture, Pa. Shares must add up to 1. Voigt and Reuss hold for any mixture,
/// Hashin and Shtrikman's (in the plane, by bulk and shear modulus) for isotropic ones.
struct ModulusBounds {
  double voigt = 0, reuss = 0, shtrikman_upper = 0, shtrikman_lower = 0;
};
ModulusBounds modulus_bounds(const std::vector<Share>& phases, double poisson);

/// A phase in space: its share of the volume and its moduli, Pa (0: void).
struct SpaceShare {
  double volume = 0, bulk = 0, shear = 0;
};
struct BulkAndShear {
  double bulk = 0, shear = 0;
  double young() const { return bulk > 0 && shear > 0 ? 9 * bulk * shear / (3 * bulk + shear) : 0; }
};

/// Bounds of the bulk and the shear modulus of a mixture in space, Pa. Shares must add up to 1. Voigt and Reuss hold
/// for any mixture, Hashin and Shtrikman's (1963, with the extremes of several phases) for isotropic ones.
struct SpaceBounds {
  BulkAndShear voigt, reuss, shtrikman_upper, shtrikman_lower;
};
SpaceBounds space_bounds(const std::vector<SpaceShare>& phases);

}  // namespace arenite::elasticity
