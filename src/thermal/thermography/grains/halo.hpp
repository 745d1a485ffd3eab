#pragma once
#include <vector>

#include "model/image.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/phase_pictures.hpp"

namespace arenite::thermography {

/// Light that lens and housing scatter far: of what a pixel would see without, this share is spread over a Gaussian
/// many pixels wide. A picture with a halo is (1 - share) times that without, plus share times its blur.
struct Halo {
  double share = 0, width = 0;  ///< -, standard deviation in pixels
  double error = 0;             ///< standard error of the share
};

/// The halo that the inner pixels of grains show: without one they are even, apart from the pattern of their warming,
/// and with one they differ by how much of the darker or brighter surroundings is near. Regression of the differences
/// within grains on those of the blurred mean picture, for several widths of the halo; errors hold the scatter from
/// grain to grain. Share 0 where it is below five errors, or where grains are too small or have no contrast.
Halo halo_of(const PhasePictures& pictures, const PictureGrains& grains, double largest_load_phase);

/// The pictures as they would be without it.
void remove_halo(const Halo& halo, PhasePictures& pictures);
/// Amplitudes of pixels at rest likewise.
void remove_halo(const Halo& halo, LockinMaps& maps);

}  // namespace arenite::thermography
