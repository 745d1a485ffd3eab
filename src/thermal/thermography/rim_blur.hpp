#pragma once
#include "thermal/thermography/grain_scene.hpp"

namespace arenite::thermography {

/// Standard deviation of a Gaussian lens, pixels, with which a drawing of even disks comes nearest to the rims of one of the
/// pictures: the film's own word on its blur. `grains` are at their mean places. No number without grains.
double rim_blur(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotion& motion, int threads);

}  // namespace arenite::thermography
