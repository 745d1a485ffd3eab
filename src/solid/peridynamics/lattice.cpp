#include "solid/peridynamics/lattice.hpp"

namespace arenite::peridynamics {

LatticeModuli lattice_moduli(double micromodulus) {
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

double calibration_factor() { return 1 / lattice_moduli().young_axis; }

}  // namespace arenite::peridynamics
