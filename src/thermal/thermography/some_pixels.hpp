#pragma once
#include <Eigen/Dense>

#include "model/film.hpp"
#include "thermal/thermography/segment_sums.hpp"

namespace arenite::thermography {

/// Some thousand pixels of every frame, spread over the picture, less their first value and over their noise from frame to
/// frame: pixels x frames. Pixels that never change, or are no numbers, are left out. Empty if `progress` stopped it.
Eigen::MatrixXd some_pixels(FilmSource& film, const Progress& progress);

}  // namespace arenite::thermography
