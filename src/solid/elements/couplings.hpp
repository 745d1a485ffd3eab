#pragma once
#include <cstdint>
#include <vector>

#include "solid/elements/elements.hpp"
#include "solid/statics/couplings.hpp"

namespace arenite::elements {

/// Galerkin sums over all elements, in double: couplings of every aggregate with itself (first, in order of aggregates)
/// and of pairs of aggregates that share an element. In a bottom row that slides, hats move nodes along x only.
std::vector<statics::Coupling> couplings(const Elements& elements, const Aggregates& aggregates,
                                         const BlockDiagonal<double>& diagonal,
                                         const std::vector<std::uint8_t>& prescribed);

}  // namespace arenite::elements
