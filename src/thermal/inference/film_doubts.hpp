#pragma once
#include <optional>
#include <string>
#include <vector>

#include "model/film_result.hpp"

namespace arenite::inference {

/// What was given beside a film, that forces and film are held against.
struct FilmGiven {
  std::optional<double> phase;                       ///< when the load is largest, rad after the first frame
  double diffusivity = 1e-7;                         ///< of heat in the grains, m^2/s
  double load_peak_to_peak = 0, load_error = 0.005;  ///< N, 0: not known; relative
  double factor_error = 0.02;                        ///< of the materials' thermoelastic factors, relative
  bool fits_factors = false;                         ///< these are those that fit the film
  double blur = 0.5;                                 ///< of the lens, pixels
  bool halo = false;                                 ///< that of the lens was given
  double height = 0, travel = 0;                     ///< of the container, and of its lower wall, m
  bool left = false, top = false;                    ///< whether these sides' places in the film were given
};

/// What the forces and the film say against what was given beside them, one sentence each with the likely causes:
/// phase, factors of the materials one against another, the scale of temperatures and forces against the load, and what
/// the fit leaves. Throws InputError where they have nothing to do with each other.
std::vector<std::string> film_doubts(const FilmGiven& given, const FilmResult& result);

}  // namespace arenite::inference
