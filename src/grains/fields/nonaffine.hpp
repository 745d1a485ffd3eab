#pragma once
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "model/packing.hpp"

namespace arenite::fields {

/// How the surroundings of every grain deformed between two states; all arrays have one entry a grain, NaN where fewer
/// than three neighbours, or neighbours in one line, leave the deformation open. Of the grains of the state before.
struct LocalDeformation {
  std::vector<std::int32_t> neighbours;
  std::vector<Tensor2>
      strain;  ///< symmetric part of F - 1, F the gradient that maps separations before to those after best
  std::vector<double> rotation;  ///< (F_yx - F_xy)/2, rad, counter-clockwise
  std::vector<double> d2min;     ///< mean over neighbours of |r' - F r|^2, m^2
};

/// D^2_min of M. L. Falk and J. S. Langer, Phys. Rev. E 57, 7192 (1998), here the mean over neighbours, not their sum.
/// Neighbours are grains whose centres are no farther apart than `range` in the state before, m, in periodic images
/// too. Grains are known by their ids: what came in or left between the states is left out. Zero under any affine
/// motion. In a periodic cell the images follow the cell: `Domain` says by how much it was stretched and sheared from
/// one state to the next, so the tilt must count on and not be set back by whole widths in between. Grains may have
/// been put back into the cell. Throws InputError for states without a grain in common or of other periodic sides, and
/// for a range that is not positive.
LocalDeformation local_deformation(const Packing& before, const Packing& after, double range);

/// The affine motion x' = F x + c nearest to that of all grains, and what is left of it.
struct AffineFit {
  Tensor2 gradient;            ///< F; NaN for fewer than three grains or grains in one line
  Vec2 shift;                  ///< c, m
  std::vector<Vec2> residual;  ///< non-affine displacement of every grain of the state before, m; NaN of one that left
  double fluctuation = 0;      ///< root of the mean square of its length, m
};

/// By least squares, all grains alike; periodic sides as in local_deformation, grains less than half a cell from where
/// the cell carries them, but for a drift of all. Throws InputError as there.
AffineFit affine_fit(const Packing& before, const Packing& after);

}  // namespace arenite::fields
