#pragma once
#include <cstdint>
#include <vector>

#include "solid/peridynamics/aggregates.hpp"
#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/load.hpp"

/// How a sample is held, and what of it hangs together.
namespace arenite::peridynamics {

/// Unit vector along which the top row moves.
Vec2 direction_of(Loading loading);

/// What is prescribed in each row of nodes (kernels.hpp). Throws InputError for shear above a sliding edge.
std::vector<std::uint8_t> prescribed_rows(int height, Loading loading, LowerEdge lower);

/// Which clamp a node moves with where it carries nothing.
enum class Tie : std::uint8_t { none = 0, below = 1, above = 2, both = 3 };

/// Cuts all bonds of what is not tied to both clamps out of `bonds`, and its nodes out of `aggregates`. `tie` says, a
/// node (padded), what it was tied to.
Support prune(Bonds& bonds, Aggregates& aggregates, const std::vector<std::uint8_t>& prescribed, Buffer<Tie>& tie);

}  // namespace arenite::peridynamics
