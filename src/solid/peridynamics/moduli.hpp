#pragma once
#include <array>

#include "solid/peridynamics/load.hpp"

namespace arenite::peridynamics {

/// Apparent moduli of a sample between rigid clamps, Pa. They hold for the sample with its clamps: a fixed edge hinders
/// contraction (LowerEdge::sliding frees one edge of it), and free sides are softer than the bulk.
struct EffectiveModuli {
  double young_x = 0, young_y = 0;      ///< pulled along x, along y
  double poisson_xy = 0, poisson_yx = 0;  ///< contraction along y when pulled along x, and the other way round
  double shear = 0;                     ///< rows moved along x; above a fixed edge
  std::array<LoadReport, 3> reports;    ///< of the pulls along x and y and of the shearing
};

/// Three loads: tension, tension of the transposed map, shear. `options.loading` is not used; the watch sees one run
/// from 0 to 1, and what it stops leaves zeros.
EffectiveModuli effective_moduli(const PhaseMap& map, const LoadOptions& options);

}  // namespace arenite::peridynamics
