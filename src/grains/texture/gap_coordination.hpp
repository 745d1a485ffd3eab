#pragma once
#include <optional>

#include "geometry/rectangle.hpp"
#include "model/packing.hpp"
#include "statistics/estimate.hpp"

namespace arenite::texture {

/// Mean numbers of neighbours a grain of two classes, large and small, where neighbours are grains whose surfaces are no farther apart than a given
/// gap (P eqs. 8, 9 and Fig. 5; there the gap is the peridynamic horizon). Errors by leaving out blocks (statistics/jackknife.hpp); NaN where a class
/// has no grains in the window.
struct GapCoordination {
  std::size_t large = 0, small = 0;    ///< grains in the window
  statistics::Estimate ll, ls;         ///< large and small neighbours of a large grain
  statistics::Estimate sl, ss;         ///< large and small neighbours of a small grain
  statistics::Estimate l, s;           ///< Z_l = Z_ll + Z_ls, Z_s = Z_sl + Z_ss
  statistics::Estimate mean;           ///< Z = (Z_l + Z_s)/2
};

/// Classes are two materials by index; grains of other materials count neither as grains nor as neighbours. Counted are grains whose centre lies in
/// the window (unset: the whole box), while neighbours may lie anywhere, in periodic images too. `gap` in m, 0 or more; grains that overlap are
/// neighbours.
/// Throws InputError for a negative gap or one material for both.
GapCoordination gap_coordination(const Packing& packing, double gap, int large = 0, int small = 1,
                                 const std::optional<geometry::Rectangle>& window = {});

}  // namespace arenite::texture
