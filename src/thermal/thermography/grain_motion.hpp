#pragma once
#include <cstdint>
#include <vector>

#include "model/film.hpp"
#include "model/image.hpp"
#include "thermal/thermography/phase_pictures.hpp"

namespace arenite::thermography {

struct GrainMotionOptions {
  double rim = 2.5;     ///< pixels inside and outside the rim that show where a grain is
  double largest = 8;   ///< pixels; a larger amplitude is not believed
  int iterations = 12;  ///< at most
  int threads = 1;
};

/// How every grain moves at the load frequency. A grain that moves by u(t) changes the level of a resting pixel by
/// -u . grad(picture), most of all at its rim, where grains differ in emissivity from what is behind them. A few pixels on
/// both sides of the rim, but none in other grains, are followed through the pictures of all phases with the motion
/// found so far; what still oscillates in them is fitted by -du . grad(picture) and a smooth thermoelastic part inside the
/// grain, until nothing is left to add. All grains first move together by an affine map, so that none loses itself.
/// `grains` are at their mean places; grains that show no contrast get that affine motion, with an error of infinity.
GrainMotion grain_motion(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotionOptions& options = {});

/// Grains that were not followed: what their motion leaves on their rims is so much that its error is beyond six times the
/// median of all grains, as that of a loose grain which goes another way than its neighbours. 1 for each of these.
std::vector<std::uint8_t> lost_grains(const GrainMotion& motion);

/// Lock-in maps whose pixels inside a grain follow it: the pictures are resampled where the grain is at every phase, and
/// mean, amplitude and second harmonic fitted anew. Rims are too sharp for pixels to be resampled beside them: a drawing of even
/// disks before an even background, seen through a lens of this `blur` (standard deviation, pixels), is taken off before and
/// the grain's own mean added after. `grains` are at their mean places; `shown` are the same grains where the maps are to show
/// them, there or, say, where they are at the largest load. Of pixels in no grain mean and drift stay, amplitudes have no value. The reference phase is
/// found anew on the inner pixels of grains unless `reference_phase` gives it. Standard errors are those of a resting pixel.
LockinMaps follow_grains(const PhasePictures& pictures, const LockinMaps& maps, const PictureGrains& grains, const GrainMotion& motion,
                         const PictureGrains& shown, std::optional<double> reference_phase = {}, int threads = 1, double blur = 0.5);

}  // namespace arenite::thermography
