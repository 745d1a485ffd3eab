#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "solid/peridynamics/aggregates.hpp"
#include "solid/peridynamics/solvers/block_diagonal.hpp"

namespace arenite::peridynamics {

/// The four bilinear hats of a cell at one of its nodes; corners in the order (0,0), (1,0), (0,1), (1,1).
using Hats = double __attribute__((vector_size(32)));

/// Stiffness between the corners of aggregate p and those of aggregate q: [component][corner of p](corner of q), Pa,
/// with the components xx, xy (x of p, y of q), yy, yx.
struct Coupling {
  std::int32_t p, q;
  std::array<std::array<Hats, 4>, 4> block;
};

/// Galerkin sums over all bonds, in double: couplings of every aggregate with itself (first, in order of aggregates)
/// and of pairs of aggregates that bonds join. In a bottom row that slides, hats move nodes along x only.
std::vector<Coupling> couplings(const Bonds& bonds, const Aggregates& aggregates, const BlockDiagonal<double>& diagonal,
                                const std::vector<std::uint8_t>& prescribed);

/// Hats at a node, whose place counts from the corner of any cell.
const Hats& hats_at(int x, int y);

}  // namespace arenite::peridynamics
