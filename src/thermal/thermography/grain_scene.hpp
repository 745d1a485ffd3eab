#pragma once
#include <vector>

#include "model/grain_swing.hpp"
#include "model/picture_grains.hpp"
#include "thermal/thermography/phase_pictures.hpp"

namespace arenite::thermography {

/// Levels of evenly bright disks before an even background: what a film would show if nothing warmed under the load.
struct GrainScene {
  std::vector<double> grain;        ///< mean of every grain
  double background = 0;
};

/// Disks whose `level` is given, through a lens that spreads a point by `blur` (standard deviation, pixels) and the mean over
/// each pixel. Disks that overlap are parted by the chord of their rims.
std::vector<float> draw_disks(const PictureGrains& grains, const std::vector<double>& level, double background, double blur, int width, int height);

/// Grains where they are in picture `k`.
PictureGrains grains_in(const PhasePictures& pictures, std::size_t k, const PictureGrains& grains, const GrainMotion& motion);

/// Finds the levels: of grains over their inner pixels, of the background where no grain reaches.
GrainScene grain_scene(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotion& motion, double blur, int threads);

/// The pictures less the scene with its grains where they are in each. Rims of grains are too sharp for the pixels to be
/// resampled; what is left here is smooth.
PhasePictures without_scene(const PhasePictures& pictures, const GrainScene& scene, const PictureGrains& grains, const GrainMotion& motion,
                            double blur, int threads);

}  // namespace arenite::thermography
