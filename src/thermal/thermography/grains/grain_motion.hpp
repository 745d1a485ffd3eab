#pragma once
#include <cstdint>
#include <vector>

#include "model/grain_motion.hpp"
#include "model/image.hpp"
#include "thermal/thermography/phase_pictures.hpp"

namespace arenite::thermography {

/// How every grain moves at the load frequency. A grain that moves by u(t) changes the level of a resting pixel by -u .
/// grad(picture), most of all at its rim, where grains differ in emissivity from what is behind them. A few pixels on
/// both sides of the rim, but none in other grains, are followed through the pictures of all phases with the motion
/// found so far; what still oscillates in them is fitted by -du . grad(picture) and a smooth thermoelastic part inside
/// the grain, until nothing is left to add. All grains first move together by an affine map, so that none loses itself.
/// `grains` are at their mean places; grains that show no contrast get that affine motion, with an error of infinity.
/// Where rims as a whole have no contrast, as of an isothermal sample, motions are 0 and all errors infinite.
GrainMotion grain_motion(const PhasePictures& pictures, const PictureGrains& grains, int threads);

}  // namespace arenite::thermography
