#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/film_result.hpp"
#include "statistics/histogram.hpp"

/// How sure contact forces are that were inferred from a film.
namespace arenite::inference {

/// 1 for each contact that counts as there, and by its force and its gap may not be; all 0 where nothing is known.
std::vector<std::uint8_t> doubtful_contacts(const FilmResult& film);

/// Of each contact how many standard errors its normal force is; empty where no errors are known.
std::vector<double> forces_over_errors(const FilmResult& film);

/// How many contacts have which ratio of normal force to standard error.
struct ForceCertainty {
  statistics::Bins bins;
  /// By bin, of contacts that are there and of doubtful ones; what lies beyond is in the first and the last bin.
  std::array<statistics::Counts, 2> there_and_doubtful;
  std::size_t below = 0, beyond = 0;  ///< contacts whose ratio lies outside of the bins
};

/// Nothing where no contact has a force and a known error.
std::optional<ForceCertainty> force_certainty(const FilmResult& film);

/// Bins over the ratio: in round steps up to the value that 98 % do not exceed, and at most some forty.
statistics::Bins certainty_bins(const std::vector<double>& ratios);

}  // namespace arenite::inference
