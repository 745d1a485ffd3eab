#pragma once
#include "thermal/thermography/harmonic_fit.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

/// How the swing at the load's frequency stands out of what swings beside it. Noise of real cameras is neither white nor
/// each pixel's own: frames follow on each other, rows and whole frames flicker together, and the electronics have lines.
struct NoiseAround {
  /// Variance of a swing over that which white noise of the same residual would give it, in the median pixel.
  double ratio = 1;
  /// Variance of what all pixels together swing over that of pixels whose noise is their own.
  double together = 1;
  /// How often the noise alone swings as much in one phase, over all frequencies that were tried; at most 1.
  double chance = 0;
  /// Share of the swing above the noise that has one phase, or its opposite, in all pixels. A load warms and cools all of
  /// a sample at once; an interference that goes over the rows as they are read out does not.
  double one_phase = 1;
};

/// Compares the swing of some thousand pixels with that at up to twelve frequencies beside it, some cycles over the
/// film away, which neither drift nor harmonics reach. `fit` is that of the maps, `tried` the number of independent
/// frequencies among which its own was found. Lines far above their neighbours are not counted as noise of the swing,
/// but do count where chance is judged.
NoiseAround noise_around(const SegmentSums& sums, const HarmonicFit& fit, double tried);

}  // namespace arenite::thermography
