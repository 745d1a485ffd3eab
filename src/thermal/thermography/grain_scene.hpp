#pragma once
#include <vector>

#include "model/film.hpp"
#include "model/image.hpp"
#include "thermal/thermography/phase_pictures.hpp"

namespace arenite::thermography {

/// Levels of evenly bright disks before an even background: what a film would show if nothing warmed under the load.
struct GrainScene {
  std::vector<double> grain;  ///< mean of every grain
  double background = 0;
};

/// Finds the levels: of grains over their inner pixels, of the background where no grain reaches.
GrainScene grain_scene(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotion& motion, double blur, int threads);

/// The pictures less the scene with its grains where they are in each. Rims of grains are too sharp for the pixels to be
/// resampled; what is left here is smooth.
PhasePictures without_scene(const PhasePictures& pictures, const GrainScene& scene, const PictureGrains& grains, const GrainMotion& motion, double blur,
                            int threads);

/// Standard deviation of a Gaussian lens, pixels, with which a drawing of even disks comes nearest to the rims of one of the
/// pictures: the film's own word on its blur. `grains` are at their mean places. No number without grains.
double rim_blur(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotion& motion, int threads);

}  // namespace arenite::thermography
