#pragma once
#include <span>
#include <vector>

#include "model/image.hpp"

namespace arenite::imaging {

/// A circle that the edges of a picture speak for.
struct Circle {
  double x = 0, y = 0, radius = 0;  ///< pixels
  double score = 0;                 ///< how much of the rim shows an edge of the right sign, 0 to 1
};

struct RimOptions {
  bool bright = true;                 ///< disks brighter than what is around them
  double smallest = 1.6, largest = 8; ///< radii of the steepest slope, pixels; in small disks it lies up to 1 pixel inside the rim
  double least = 0.1;                 ///< score below which a circle is not listed
  std::span<const char> open = {};    ///< one a pixel, 0 where no centre can lie; empty: everywhere
};

/// Circles whose rims show edges: the slope along the normal in a ring, against the root mean square slope nearby, each
/// pixel's share cut at 1 (and at -0.3 for the wrong sign), so that uneven light, unlike materials and single strong edges
/// count little. Radii go up by 5 % a step, on pictures halved until a radius is below 8 pixels. Local maxima over place and
/// radius, best first. What of a rim lies outside the picture
/// counts as not seen.
std::vector<Circle> search_rims(const FloatImage& image, const RimOptions& options);

}  // namespace arenite::imaging
