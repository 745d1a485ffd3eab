#pragma once
#include "model/film_result.hpp"

namespace arenite::study {

/// Adds to the errors of the stresses what a blur of the lens that is known to `blur_error` only leaves; `wider` are the
/// stresses when rims are taken off with a blur larger by `step` (pixels).
void add_blur_error(GrainSwing& swing, const GrainSwing& wider, double step, double blur_error);

/// Adds what noise does not tell, once the forces are known: the mean over a grain's centre differs from the mean that the
/// forces (held by the balance of all grains) put there, seen through the same lens and pixels. The median difference of
/// the grains of a material is the error of all of them that rim, motion and the camera's fixed pattern leave; a grain whose own
/// difference is larger than that is less sure. `shown` are the grains in the maps' pixels, `share` the part averaged.
void add_fit_error(FilmResult& result, const PictureGrains& shown, double share);

}  // namespace arenite::study
