#pragma once
#include "model/phase_map.hpp"

namespace arenite::raster {

/// Shares of the nodes of a map (P II.A), by counting.
struct PhaseFractions {
  double particle = 0, matrix = 0, empty = 0;  ///< rho_p, rho_m, rho_v
  double large = 0, small = 0;                 ///< rho_L, rho_S: the particle nodes of classed grains
  /// S_m = rho_m/(1 - rho_p) (P III); 0 where all is grain.
  double saturation = 0;
};

PhaseFractions phase_fractions(const PhaseMap& map);

}  // namespace arenite::raster
