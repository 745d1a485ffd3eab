#pragma once
#include <vector>

#include "core/vec2.hpp"
#include "solid/peridynamics/bonds.hpp"

namespace arenite::peridynamics {

/// A straight cut through all bonds that cross it, in nodes: a notch without width.
struct Cut {
  Vec2 from, to;
};

/// Breaks every bond that a cut crosses.
void make_cuts(Bonds& bonds, const std::vector<Cut>& cuts);

}  // namespace arenite::peridynamics
