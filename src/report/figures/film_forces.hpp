#pragma once
#include <vector>

#include "report/figures/film_figures.hpp"

/// Contact forces that were inferred from a film.
namespace arenite::report::figures {

/// Peak to peak, ranked, with their standard errors.
Drawings ranked_forces(const FilmData& data);
/// How many contacts have which ratio of force to error.
Drawings certainty(const FilmData& data);
/// Steps of bars over F_n / standard error, the first edge and the number of bars: round steps up to the value that
/// 98 % do not exceed; what lies beyond is in the first and the last bar.
struct Bins {
  double first = 0, step = 1;
  int count = 0;
};
Bins certainty_bins(std::vector<double> ratios);

}  // namespace arenite::report::figures
