#pragma once
#include <optional>
#include <vector>

namespace arenite::elasticity {

/// A phase of a plane mixture: its share of the area, its modulus, Pa (0: void), and its Poisson's ratio.
struct Share {
  double area = 0, young = 0;
  double poisson = 1.0 / 3;
};

/// Bounds of Young's modulus of a plane mixture in plane stress, Pa; nothing where its solid phases differ in Poisson's
/// ratio. Shares must add up to 1. Voigt and Reuss hold for any mixture, Hashin and Shtrikman's (in the plane, by bulk
/// and shear modulus) for isotropic ones.
struct ModulusBounds {
  double voigt = 0, reuss = 0, shtrikman_upper = 0, shtrikman_lower = 0;
};
std::optional<ModulusBounds> modulus_bounds(const std::vector<Share>& phases);

/// Moduli of something isotropic in D dimensions, Pa. In the plane bulk is E/(2(1 - nu)) in plane stress: half the sum
/// of the stresses over the sum of the strains.
template <int D> struct BulkAndShear {
  double bulk = 0, shear = 0;
  double young() const {
    if (!(bulk > 0 && shear > 0)) return 0;
    return D == 2 ? 4 * bulk * shear / (bulk + shear) : 9 * bulk * shear / (3 * bulk + shear);
  }
};

/// A phase: its share of the sample and its moduli (0: void).
template <int D> struct PhaseShare {
  double share = 0;
  BulkAndShear<D> moduli{};
};

/// Bounds of the bulk and the shear modulus of a mixture, Pa. Shares must add up to 1. Voigt and Reuss hold for any
/// mixture, Hashin and Shtrikman's (1963; with the extremes of several phases) for isotropic ones.
template <int D> struct BoundsIn { BulkAndShear<D> voigt, reuss, shtrikman_upper, shtrikman_lower; };
template <int D> BoundsIn<D> bounds(const std::vector<PhaseShare<D>>& phases);

}  // namespace arenite::elasticity
