#pragma once
#include <cstddef>
#include <vector>

#include "model/grain_motion.hpp"
#include "model/image.hpp"
#include "thermal/thermography/phase_pictures.hpp"

/// Where grains are during a cycle of the load, that were found at its smallest.
namespace arenite::thermography {

/// Grains when they have gone this share of their way from the smallest to the largest load, which goes as
/// cos(2 pi f t - phase): 0.5 is the middle of their motion.
PictureGrains moved(const PictureGrains& smallest, const GrainMotion& motion, double phase, double share);

/// The motion of grains that were found at the smallest load. `middle`, their places in the middle of the cycle as far
/// as these are known, is what a motion is fitted about; it follows from the motion, so both are found in turns.
GrainMotion motion_from_smallest(const PhasePictures& pictures, const PictureGrains& smallest, double phase,
                                 PictureGrains& middle, int threads);

/// Motion of grains between a lower wall that travels by `travel` pixels from the smallest to the largest load and an
/// upper one that rests, strained evenly between: `height` is that of each grain over the container's, 0 at the lower
/// wall. The error, of each of the four coordinates, is a tenth of a pixel and of the amplitude.
GrainMotion motion_with_wall(const std::vector<double>& height, double travel, double phase);

/// Standard error of each coordinate of a grain's way from the smallest to the largest load, pixels: what residuals of
/// its rim tell, and a share of its travel. Pixels sample rims whose blur is hardly wider than they are, and what is
/// lost between them looks like motion in every frame, so that no residual shows it.
double error_of_way(const GrainMotion& motion, std::size_t grain);

/// The same grains with position errors that hold those of the whole way of their motion.
PictureGrains with_errors_of_way(PictureGrains grains, const GrainMotion& motion);

/// What is known of the places of lost grains (`lost_grains`). A loose grain may go quite another way than its
/// neighbours, but none goes into others: a way that ends deeper in one of them than they lie in each other, and than
/// the mean way of the nearest would, is none, and the grain goes with these. Returns the standard error of each lost
/// grain's place at the largest load, pixels; 0 for all others, empty where none is lost.
std::vector<double> settle_lost(const PictureGrains& smallest, double phase, GrainMotion& motion);

/// Makes unknown what stands in the maps where a grain was thought to be, and was not (`lost_grains`); how many.
std::size_t forget_lost(const GrainMotion& motion, PeakToPeak& change);

}  // namespace arenite::thermography
