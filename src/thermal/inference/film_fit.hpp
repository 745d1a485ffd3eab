#pragma once
#include <vector>

#include "model/film_result.hpp"
#include "statistics/estimate.hpp"

/// How a film and the contact forces that were inferred from it compare, as every picture shows it.
namespace arenite::inference {

/// Maps in the film's unit, peak to peak, rows from the top; NaN in pixels that the maps or the forces leave open.
struct FitMaps {
  std::vector<float> measured;  ///< warming with the load
  std::vector<float> fitted;    ///< as the forces make the maps show it
  std::vector<float> residual;  ///< measured less fitted
};

/// Empty without forces.
FitMaps fit_maps(const FilmResult& film);

/// Root mean square over the pixels that have a number; unknown without any.
double root_mean_square(const std::vector<float>& map);

}  // namespace arenite::inference
