#pragma once
#include <string>

#include "report/figure_list.hpp"
#include "statistics/numbers.hpp"
#include "workflow/final_state.hpp"

namespace arenite::report {

/// One state as JSON for a figure: `size` of the box in mm; `x`, `y`, `r` of the grains in mm from its lower left corner,
/// their `material`, a place in `materials`, and 1 for those that are `glued`; for FigureKind::forces the contacts between grains
/// `i`, `j` with their normal force `f` over the mean push, for FigureKind::stresses `stress` of the grains over the mean.
Numbers sample_drawing(const study::FinalState& state, FigureKind kind);

/// The same of the grains that a film shows, with `stress` as it gives them over their mean; `film` is what is kept of it
/// (ledger/virtual_film.hpp). Throws InputError if that is no film's.
Numbers film_drawing(const Numbers& film);

}  // namespace arenite::report
