#pragma once
#include <vector>

#include "model/grain_motion.hpp"
#include "model/image.hpp"
#include "model/lockin_maps.hpp"

namespace arenite::thermography {

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

}  // namespace arenite::thermography
