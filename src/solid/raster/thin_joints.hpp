#pragma once
#include "solid/raster/joint_shape.hpp"
#include "solid/raster/lattice.hpp"
#include "solid/raster/raster.hpp"

namespace arenite::raster {

/// Fewest nodes of a joint on a line of the lattice (column or row, whichever lies more across it) that crosses the gap
/// between its grains; at least the line nearest to the gap's middle is looked at. Lines go on beyond the crop.
int nodes_across(const Lattice& lattice, const JointShape& shape);

/// Notes a joint, of which the raster made `matrix_nodes` nodes matrix, if the middle of its gap lies in the crop.
void note_joint(const Lattice& lattice, const JointShape& shape, int matrix_nodes, RasterReport& report);

}  // namespace arenite::raster
