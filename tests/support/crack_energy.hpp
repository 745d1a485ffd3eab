#pragma once
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "solid/peridynamics/lattice.hpp"

namespace arenite::peridynamics {

/// Energy that opening a crack costs per unit length and squared critical stretch, for E = dx = 1: the sum over the
/// bonds that cross a line along the axes, or along the diagonal.
inline double crack_energy_axis(double micromodulus = nominal_micromodulus) {
  double g = 0;
  for (const auto e : half_bonds) g += micromodulus * length(e) / 2 * e.y;
  return g;
}
inline double crack_energy_diagonal(double micromodulus = nominal_micromodulus) {
  double g = 0;
  for (const auto e : half_bonds) g += micromodulus * length(e) / 2 * std::abs(e.x + e.y) / std::numbers::sqrt2;
  return g;
}

}  // namespace arenite::peridynamics
