#pragma once
#include <cstdint>
#include <vector>

#include "solid/peridynamics/solvers/pieces.hpp"

namespace arenite::peridynamics {

/// What of a sample hangs together between its two clamps; counts are nodes that are not void.
struct Support {
  std::size_t solid = 0;
  std::size_t carrying = 0;    ///< tied to both clamps
  std::size_t held_below = 0;  ///< tied to the lower clamp only: moves with it, without stress
  std::size_t held_above = 0;  ///< tied to the upper clamp only
  std::size_t floating = 0;    ///< tied to neither: left where it is, without stress
  int islands = 0;             ///< separate parts among the floating
};

/// Which clamp a node moves with where it carries nothing.
enum class Tie : std::uint8_t { none = 0, below = 1, above = 2, both = 3 };

/// Cuts all bonds of what is not tied to both clamps out of `bonds`, and its nodes out of `pieces`. `tie` says, a node
/// (padded), what it was tied to.
Support prune(Bonds& bonds, Pieces& pieces, const std::vector<std::uint8_t>& prescribed, Buffer<Tie>& tie);

}  // namespace arenite::peridynamics
