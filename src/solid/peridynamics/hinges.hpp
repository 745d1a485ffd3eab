#pragma once
#include <cstdint>
#include <vector>

#include "solid/peridynamics/bonds.hpp"

namespace arenite::peridynamics {

/// A node about which a part of the sample can turn, because nothing else ties that part to the rest.
struct Hinge {
  std::int32_t x, y;  ///< node
  std::size_t nodes;  ///< of the part behind it, seen from the bottom row
  bool carries;       ///< the part holds the upper clamp: the load itself passes the hinge
};

/// All hinges of what is tied to the bottom row: cut nodes of the graph of bonds (R. Tarjan, 1972), sorted by row, then
/// column. Single nodes on two or more bonds that are not in line, and parts held by two nodes, are no hinges.
std::vector<Hinge> find_hinges(const Bonds& bonds);

}  // namespace arenite::peridynamics
