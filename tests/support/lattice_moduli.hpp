#pragma once
#include <cmath>

#include "solid/peridynamics/lattice.hpp"

namespace arenite::peridynamics {

/// Elastic constants of the infinite homogeneous lattice for E = 1: exact sums over the 28 bonds.
struct LatticeModuli {
  double c1111, c1122;              ///< c1212 = c1122 in any bond lattice
  double young_axis, poisson_axis;  ///< along x or y
  double young_diagonal, poisson_diagonal;
};
inline LatticeModuli lattice_moduli(double micromodulus = nominal_micromodulus) {
  double c11 = 0, c12 = 0;
  for (const auto e : half_bonds) {
    const double l3 = std::pow(length(e), 3), xx = e.x * e.x, yy = e.y * e.y;
    c11 += micromodulus * (xx * xx + yy * yy) / 2 / l3;  // both axes, so that a half of the bonds stands for all
    c12 += micromodulus * xx * yy / l3;
  }
  const double c66 = c12;
  const double d11 = (c11 + c12 + 2 * c66) / 2, d12 = (c11 + c12 - 2 * c66) / 2;
  return {c11, c12, c11 - c12 * c12 / c11, c12 / c11, d11 - d12 * d12 / d11, d12 / d11};
}

}  // namespace arenite::peridynamics
