#pragma once
#include "handles.hpp"
#include "slab.hpp"

namespace arenite::cluster {

/// The stiffness on the coarse mesh, whose hats are trilinear over two cells each way: the Galerkin sums of all cells,
/// assembled, with the rigid modes that algebraic multigrid asks for.
Matrix coarse_stiffness(const Slab& slab);

}  // namespace arenite::cluster
