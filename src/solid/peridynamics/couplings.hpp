#pragma once
#include <cstdint>
#include <vector>

#include "solid/peridynamics/bonds.hpp"
#include "solid/statics/aggregates.hpp"
#include "solid/statics/block_diagonal.hpp"
#include "solid/statics/couplings.hpp"

namespace arenite::peridynamics {

/// Galerkin sums over all bonds, in double: couplings of every aggregate with itself (first, in order of aggregates)
/// and of pairs of aggregates that bonds join. In a bottom row that slides, hats move nodes along x only.
std::vector<Coupling> couplings(const Bonds& bonds, const Aggregates& aggregates, const BlockDiagonal<double>& diagonal,
                                const std::vector<std::uint8_t>& prescribed);

}  // namespace arenite::peridynamics
