#pragma once
#include "model/film_result.hpp"
#include "statistics/numbers.hpp"

namespace arenite::study {

/// Directions of the contacts that a film shows and, where it is given, of those of a simulation beside it: "film" and
/// "twin", each with "contacts", "a_c", "theta_c_deg", "a_c_noise" and the numbers in "sectors" of 10 degrees, over the
/// same window (without the border). Empty without contacts.
Numbers film_directions(const FilmResult& film, const Packing* twin = nullptr);

}  // namespace arenite::study
