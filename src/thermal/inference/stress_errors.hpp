#pragma once
#include "model/film_result.hpp"
#include "model/grain_motion.hpp"
#include "model/image.hpp"

/// What noise does not tell of the errors of grains' stresses.
namespace arenite::inference {

/// Adds to the errors of the stresses what a blur of the lens that is known to `blur_error` only leaves; `wider` are
/// the stresses when rims are taken off with a blur larger by `step` (pixels).
void add_blur_error(PeakToPeak& change, const PeakToPeak& wider, double step, double blur_error);

/// By how much an assumed blur may be off, pixels: by what the rims of the grains show instead (0: nothing), and never
/// by less than 0.05, which is what rims show of the blur at best.
double blur_error(double seen_at_rims, double assumed);

/// Adds to the errors of the stresses what is not known of the halo that was taken off; `scattered` are the stresses
/// with it, and what it costs goes to `result.halo`.
void add_halo_error(FilmResult& result, const PeakToPeak& scattered);

/// What is known of the materials' thermoelastic factors.
struct GivenFactors {
  double error = 0.02;     ///< standard error of those that are given, relative
  bool fitted = false;     ///< those that fit the film count
  bool with_load = false;  ///< forces tell factors from the load
};

/// Adds to the errors of the stresses that of the thermoelastic factors: the one given, or where forces tell it from
/// the load the fit's own with what is between the fitted factors and the given ones. Where fitted factors count,
/// stresses are first those of these.
void add_factor_error(const GivenFactors& given, FilmResult& result);

/// Adds what noise does not explain, once the forces are known: the mean over a grain's centre differs from the mean
/// that the forces (held by the balance of all grains) put there, seen through the same lens and pixels. The median
/// difference of the grains of a material is the error of all of them that rim, motion and the camera's fixed pattern
/// leave; a grain whose own difference is larger than that is less sure. `shown` are the grains in the maps' pixels,
/// `share` the part averaged.
void add_fit_error(FilmResult& result, const PictureGrains& shown, double share);

}  // namespace arenite::inference
