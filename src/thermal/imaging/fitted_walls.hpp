#pragma once
#include "model/packing.hpp"

namespace arenite::imaging {

/// Where the rims of grains show a side of their container to be.
struct FittedWall {
  double shift = 0;          ///< from where it was said to be, into the sample, m
  double error = 0;          ///< standard error, m
  std::size_t touching = 0;  ///< grains whose rims lie on it; nothing is known from fewer than two
  bool known() const { return touching >= 2; }
};

/// Sides as the grains beside them show them. A wall that carries load is touched by some of them, and none reaches
/// through it: of all places within `reach` (m) that is the one on which most rims lie that has the fewest rims beyond.
/// `rim_error` is that of a rim along the wall's normal, m. Sides that are absent or touched by fewer than two grains
/// are not known.
BySide<FittedWall> fit_walls(const Grains& grains, const Domain& domain, double rim_error, double reach);

/// The container with its known sides where they were found.
Domain with_fitted_walls(Domain domain, const BySide<FittedWall>& walls);

}  // namespace arenite::imaging
