#pragma once
#include <vector>

#include "report/figures/drawing.hpp"
#include "thermal/inference/film_stresses.hpp"

namespace arenite::report::figures {

/// A film, with the stresses of its grains beside those of its companion simulation.
struct FilmData {
  const FilmResult& result;
  const inference::FilmStresses& stresses;
};

/// Figures of a film, in their order on the page.
const std::vector<Row<FilmData>>& film_figures();

/// Those of contact forces.
Drawings ranked_forces(const FilmData& data);
Drawings certainty(const FilmData& data);
/// Steps of bars over F_n / standard error, the first edge and the number of bars: round steps up to the value that
/// 98 % do not exceed; what lies beyond is in the first and the last bar.
struct Bins {
  double first = 0, step = 1;
  int count = 0;
};
Bins certainty_bins(std::vector<double> ratios);

}  // namespace arenite::report::figures
