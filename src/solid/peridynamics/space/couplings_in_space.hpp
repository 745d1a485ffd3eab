#pragma once
#include <cstdint>
#include <vector>

#include "solid/peridynamics/space/bonds_in_space.hpp"
#include "solid/statics/aggregates.hpp"
#include "solid/statics/block_diagonal.hpp"
#include "solid/statics/couplings.hpp"

namespace arenite::peridynamics {

/// Galerkin sums over all bonds, in double, one layer of coarse cells after the other. In a lowest level that slides,
/// hats move nodes across the clamps by nothing. `bonds` is asked again when the sums are.
statics::GalerkinSums<3> couplings(const SpaceBonds& bonds, const statics::Aggregates& aggregates,
                                   statics::BlockDiagonalIn<3, double> diagonal,
                                   const std::vector<std::uint8_t>& prescribed);

}  // namespace arenite::peridynamics
