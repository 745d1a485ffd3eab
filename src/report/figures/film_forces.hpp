#pragma once
#include "report/figures/film_figures.hpp"

/// Contact forces that were inferred from a film.
namespace arenite::report::figures {

/// Peak to peak, ranked, with their standard errors.
Drawings ranked_forces(const FilmData& data);
/// How many contacts have which ratio of force to error.
Drawings certainty(const FilmData& data);

}  // namespace arenite::report::figures
