#pragma once
#include <vector>

#include "model/image.hpp"
#include "thermal/imaging/blur.hpp"
#include "thermal/imaging/disk_model.hpp"

namespace arenite::imaging {

struct RimOptions {
  bool bright = true;  ///< disks brighter than what is around them
  double smallest = 1.6,
         largest = 8;  ///< radii of the steepest slope, pixels; in small disks it lies up to 1 pixel inside the rim
  double least = 0.1;  ///< score below which a circle is not listed
  const Mask* open = nullptr;  ///< where centres can lie; null: everywhere
};

/// Circles whose rims show edges: the slope along the normal in a ring, against the root mean square slope nearby, each
/// pixel's share cut at 1 (and at -0.3 for the wrong sign), so that uneven light, unlike materials and single strong
/// edges count little. Radii go up by 5 % a step, on pictures halved until a radius is below 8 pixels. Local maxima
/// over place and radius, best first. What of a rim lies outside the picture counts as not seen.
std::vector<Circle> search_rims(const FloatImage& image, const RimOptions& options);

}  // namespace arenite::imaging
