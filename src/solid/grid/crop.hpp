#pragma once
#include <cstdint>
#include <vector>

#include "model/cement.hpp"
#include "model/packing.hpp"

namespace arenite::grid {

/// The grains that a grid shows, in its coordinates, and what holds them.
struct CroppedPacking {
  Packing packing;
  Cement cement;
};

/// First the grains of the labels, in their order, then those that touch one of them or share a bridge or meniscus with
/// one; contacts and necks between these. `corner` becomes the origin.
CroppedPacking crop(const Packing& packing, const Cement& cement, const std::vector<std::int32_t>& grain_of_label,
                    Vec2 corner);

/// The mirror image about the line x = y, as transposed(PhaseMap) gives it.
Packing transposed(const Packing& packing);

}  // namespace arenite::grid
