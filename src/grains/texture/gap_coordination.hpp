#pragma once
#include <optional>

#include "geometry/rectangle.hpp"
#include "model/packing.hpp"
#include "statistics/numbers.hpp"

namespace arenite::texture {

/// Numbers of grains of two classes, large and small, and mean numbers of neighbours a grain, which are grains whose
/// surfaces are no farther apart than a given gap (P eqs. 8, 9 and Fig. 5; there the gap is the peridynamic horizon):
/// "Z_ls" small neighbours of a large grain, Z_l = Z_ll + Z_ls, Z_s = Z_sl + Z_ss, Z = (Z_l + Z_s)/2. Errors by leaving
/// out blocks (statistics/jackknife.hpp); what a class without grains in the window leaves open is left out.
///
/// Classes are two materials by index; grains of other materials count neither as grains nor as neighbours. Counted are
/// grains whose centre lies in the window (unset: the whole box), while neighbours may lie anywhere, in periodic images
/// too. `gap` in m, 0 or more; grains that overlap are neighbours. Throws InputError for a negative gap or one material
/// for both.
Numbers gap_coordination(const Packing& packing, double gap, int large = 0, int small = 1,
                         const std::optional<geometry::Rectangle>& window = {});

}  // namespace arenite::texture
