#pragma once
#include "model/domain.hpp"
#include "model/grains.hpp"

namespace arenite::packing {

/// What a relaxation found and did; overlaps are relative to the mean radius of the two grains (a wall counts as the grain).
struct RelaxReport {
  double overlap_before = 0;   ///< largest
  double overlap_after = 0;    ///< largest
  double largest_move = 0;     ///< m
  int iterations = 0;
};

/// Pushes grains apart until no overlap is larger than `tolerance` (relative), by following the gradient of the overlap
/// energy sum of h^2 downhill with inertia (FIRE: E. Bitzek et al., PRL 97, 170201, 2006). Geometry only: sizes count,
/// materials do not. Ends at `max_iterations` in a jammed sample; the report says what is left.
RelaxReport relax(Grains& grains, const Domain& domain, double tolerance = 1e-4, int max_iterations = 20'000);

}  // namespace arenite::packing
