#pragma once
#include <vector>

#include "model/lockin_maps.hpp"
#include "model/picture_grains.hpp"
#include "thermal/radiometry/band.hpp"

namespace arenite::thermography {

/// What temperatures were made with, and what grains are.
struct GrainSurfaces {
  radiometry::Band band;
  radiometry::Surface assumed;      ///< of everything in the film, so far
  std::vector<double> emissivity;   ///< of every material; empty: nothing is known of them
};

/// Maps in kelvin that were made as if everything were the assumed surface, as each grain's own material shows them: its pixels' mean, and
/// what swings about it by the slope of Planck's law there. A pixel belongs to the grain that covers its middle, and those just beyond a rim
/// to the nearest grain; the rest stays as it is. Maps are unchanged where materials are as assumed.
void see_surfaces(LockinMaps& maps, const PictureGrains& grains, const GrainSurfaces& surfaces);

}  // namespace arenite::thermography
