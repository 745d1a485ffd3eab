#pragma once
#include <cstdint>
#include <vector>

#include "model/film.hpp"
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
GrainMotion grain_motion(const PhasePictures& pictures, const PictureGrains& grains, int threads = 1);

/// Grains that were not followed: what their motion leaves on their rims is so much that its error is beyond six times
/// the median of all grains, as that of a loose grain which goes another way than its neighbours. 1 for each of these.
std::vector<std::uint8_t> lost_grains(const GrainMotion& motion);

/// Whether rims showed the motion of any grain.
bool is_seen(const GrainMotion& motion);

/// Of every pixel the grain whose rim is furthest out of it, or nearest, for those no further than `beyond` from it; -1
/// for all others. Neighbours may overlap in a picture, but each pixel belongs to one grain.
std::vector<std::int32_t> owners(const PictureGrains& grains, int width, int height, double beyond);

/// Lock-in maps whose pixels inside a grain follow it: the pictures are resampled where the grain is at every phase,
/// and mean, amplitude and second harmonic fitted anew. Rims are too sharp for pixels to be resampled beside them: a
/// drawing of even disks before an even background, seen through a lens of this `blur` (standard deviation, pixels), is
/// taken off before and the grain's own mean added after. `grains` are at their mean places; `shown` are the same
/// grains where the maps are to show them, there or, say, where they are at the largest load. Of pixels in no grain
/// mean and drift stay, amplitudes have no value. The reference phase is found anew on the inner pixels of grains
/// unless `reference_phase` gives it. Standard errors are those of a resting pixel.
LockinMaps follow_grains(const PhasePictures& pictures, const LockinMaps& maps, const PictureGrains& grains,
                         const GrainMotion& motion, const PictureGrains& shown,
                         std::optional<double> reference_phase = {}, int threads = 1, double blur = 0.5);

struct GrainMeanOptions {
  double share = 0.5;  ///< of a grain's area that is averaged, round its centre
  /// Thermoelastic factor A of every material, K/Pa: dT = -A d(sigma_kk), so that d(sigma_hyd) = -dT/(2 A). It belongs
  /// to the peak-to-peak change of both, from the smallest to the largest load.
  std::vector<double> factor;
};

/// Peak-to-peak change of every grain from the mean of the signed map over its central part: pixels weigh as much as
/// the disk covers of them. Without body forces sigma_kk is harmonic, so its mean over a concentric disk of any size is
/// the grain's. Maps are in K, of whichever convention they state. The error holds the pixels' standard errors and the
/// centre's position error times the slope of the mean when the disk is shifted; it is infinite for a grain of which no
/// pixel has a value. Throws InputError for a share out of (0, 1] and for a grain's material without factor.
PeakToPeak grain_means(const LockinMaps& maps, const PictureGrains& grains, const GrainMeanOptions& options);

/// Mean of a map over a disk by covered area, pixels without a value left out.
struct DiskMean {
  double mean = 0;   ///< no number where no pixel has a value
  double error = 0;  ///< from the pixels' errors
  double area = 0;   ///< pixels
};

/// Of a map beside those of the lock-in, whose standard errors are the pixels', over a disk: centre and radius in
/// pixels.
DiskMean disk_mean(const LockinMaps& maps, const std::vector<float>& map, Vec2 centre, double radius);

/// Standard deviation of a Gaussian lens, pixels, with which a drawing of even disks comes nearest to the rims of one
/// of the pictures: the film's own word on its blur. `grains` are at their mean places. No number without grains.
double rim_blur(const PhasePictures& pictures, const PictureGrains& grains, const GrainMotion& motion, int threads);

}  // namespace arenite::thermography
