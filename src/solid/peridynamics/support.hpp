#pragma once
#include <cstdint>
#include <vector>

#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/load.hpp"

/// How a sample is held, and what of it hangs together.
namespace arenite::peridynamics {

/// Cuts all bonds of what is not tied to both clamps out of `bonds`, and its nodes out of `aggregates`. `tie` says, a
/// node (padded), what it was tied to.
Support prune(Bonds& bonds, Aggregates& aggregates, const std::vector<std::uint8_t>& prescribed, Buffer<Tie>& tie);

}  // namespace arenite::peridynamics
