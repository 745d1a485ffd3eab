#pragma once
#include <vector>

#include "model/domain.hpp"
#include "model/film_result.hpp"

namespace arenite::inference {

/// What is known beside a film when forces are inferred from it.
struct FilmForcesGiven {
  bool from_pixels = true;                           ///< otherwise from the means of grains
  double load_peak_to_peak = 0, load_error = 0.005;  ///< on the lower wall, N, 0: not known; relative
  double blur = 0.5;                                 ///< of the lens, pixels
  bool grains_move = true;                           ///< over the pixels, with the load
  double friction = 0.3;
  bool state = false;          ///< the film shows a state and no difference: the friction cone holds
  double factor_error = 0.02;  ///< standard error of the materials' thermoelastic factors, relative
  bool fits_factors = false;   ///< these are those that fit the film
  int threads = 1;
  std::vector<double> unseen = {};  ///< standard error of the place of grains whose motion was lost, pixels; 0: others
};

/// Proposes contacts between the grains of `result.packing` and infers their forces from its maps, or from the means of
/// grains. Contacts are proposed where grains touch at the largest or at the smallest load (`result.grains`, in the
/// container `start`): one that opens on the way loses its force.
void infer_film_forces(const FilmForcesGiven& given, const Domain& start, FilmResult& result);

}  // namespace arenite::inference
