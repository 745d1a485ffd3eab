#pragma once
#include <array>

#include "solid/peridynamics/bonds.hpp"
#include "solid/statics/block_diagonal.hpp"

namespace arenite::peridynamics {

/// Stiffness of a bond by its direction and type.
using BondBlocks = std::array<std::array<Block, 4>, bonds_per_node>;
BondBlocks bond_blocks(const Bonds& bonds);

BlockDiagonal<double> block_diagonal(const Bonds& bonds);

}  // namespace arenite::peridynamics
