#pragma once
#include <vector>

#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/load.hpp"

namespace arenite::peridynamics {

/// All hinges of what is tied to the bottom row: cut nodes of the graph of bonds (R. Tarjan, 1972), sorted by row, then
/// column. Single nodes on two or more bonds that are not in line, and parts held by two nodes, are no hinges.
std::vector<Hinge> find_hinges(const Bonds& bonds);

}  // namespace arenite::peridynamics
