#pragma once
#include <string>

#include "model/film_result.hpp"
#include "statistics/numbers.hpp"

namespace arenite::study {

/// Statistics of what a film gave, as `arenite film --json` prints them: frequency, noise, grains by material, motion,
/// sigma_norm (by the code that measures simulated packings), contact forces, directions of contacts, and the comparison
/// with the twin, of whose state at the largest load the contacts count.
Numbers film_numbers(const FilmResult& result, const Packing* twin = nullptr);

/// How two stresses of the same grains agree: correlation, root mean square difference of sigma_norm (each over the mean of
/// its own), slope through the origin.
struct Agreement {
  std::size_t grains = 0;
  double correlation = 0, rms_sigma_norm = 0, slope = 0;
};
/// Grains where `counts` is 0 are left out.
Agreement agreement(const std::vector<double>& one, const std::vector<double>& other, const std::vector<std::uint8_t>& counts);

}  // namespace arenite::study
