#pragma once
#include "model/image.hpp"
#include "thermal/imaging/registration.hpp"

namespace arenite::imaging {

struct OverlayOptions {
  double reach = 8;     ///< how far the circles may lie off their first place, pixels
  double turn = 0.035;  ///< how far they may be turned, rad
};

/// How circles lie on a picture that shows the same grains.
struct Overlay {
  Similarity transform;    ///< from the circles' picture to this one
  double correlation = 0;  ///< of the picture with the area that the circles cover; below 0 where grains are darker
  double rms = 0;          ///< between circles that were fitted one by one and their places, along one axis, pixels
  double shift_error = 0;  ///< standard error: pixels at the middle of the grains
  double turn_error = 0;   ///< of scale and of rotation: pixels a pixel from there
};

/// Lays circles found in one picture on another in which single grains need not be told apart: the place at which what
/// they cover looks most like the picture (shifts by whole pixels, turns by a pixel at the edge), then all circles
/// fitted to it (DiskModel) and the similarity fitted to these, outliers left out. `first` says where they lie nearly.
/// Throws InputError for fewer than three circles.
Overlay lay_over(const PictureGrains& circles, const Similarity& first, const FloatImage& picture,
                 const OverlayOptions& options = {});

}  // namespace arenite::imaging
