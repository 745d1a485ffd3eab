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

}  // namespace arenite::elasticity
