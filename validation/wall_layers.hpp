#pragma once
#include "validation/final_texture.hpp"

namespace arenite::validation {

/// Mean share that lies further than `strip` from both ends of a unit length, of a window of length `window` at a
/// random place wholly in it. `strip` at most 1/2.
double share_of_interior(double window, double strip);

/// Solid fraction in a strip along the walls, and within that which the statistics leave out.
struct WallLayers {
  double strip_x = 0, strip_y = 0;  ///< width of the strip over that of the box
  double at_walls = statistics::unknown, within = statistics::unknown;
  /// Of windows of the box's shape with this share of its area, if each of both were even.
  double of_windows(double area_share) const;
};
/// What is missing along the walls is taken to lie in a strip of that many mean diameters.
WallLayers wall_layers(const FinalState& state, double diameters);

/// Solid fraction of windows of growing size within the strip.
texture::Rev rev_within(const FinalState& state);

}  // namespace arenite::validation
