#pragma once
#include <cstdint>
#include <vector>

#include "core/vec2.hpp"
#include "solid/peridynamics/kernels/kernels.hpp"

namespace arenite::peridynamics {

/// How the top row of nodes is moved against the bottom row: up, down, or to the right.
enum class Loading { tension, compression, shear };

/// What holds the bottom row: both components fixed, or free to slide along x (the top row is always held in x).
enum class LowerEdge { fixed, sliding };

/// Unit vector along which the top row moves.
Vec2 direction_of(Loading loading);

/// What is prescribed in each row of nodes (kernels.hpp). Throws InputError for shear above a sliding edge.
std::vector<std::uint8_t> prescribed_rows(int height, Loading loading, LowerEdge lower);

}  // namespace arenite::peridynamics
