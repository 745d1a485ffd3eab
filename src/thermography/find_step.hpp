#pragma once
#include <vector>

#include "model/film.hpp"
#include "thermography/step_load.hpp"

namespace arenite::thermography {

/// The time in the middle between the two frames between which some thousand pixels, spread over the picture, jump most:
/// each split of the film is judged by what polynomials of this order on both sides explain, over the noise of the pixel.
/// InputError where no split explains more than noise does; negative if `progress` stopped it.
double find_step(FilmSource& film, const std::vector<double>& time, int drift_order, const Progress& progress);

}  // namespace arenite::thermography
