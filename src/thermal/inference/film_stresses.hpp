#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "model/film_result.hpp"
#include "statistics/correlation.hpp"
#include "statistics/numbers.hpp"

namespace arenite::inference {

/// Stress of the grains from one source, Pa, tension positive.
struct GrainStresses {
  std::string source;                 ///< "film", "simulation_peak_to_peak", "simulation_state"
  std::vector<double> sigma_hyd;      ///< one a grain; NaN where it is not known in every source
  std::vector<double> sigma_norm;     ///< over `mean`
  double mean = statistics::unknown;  ///< of the grains that count, Pa
};

/// The stresses of a film and, where there is one, of its companion simulation, peak to peak and as the state at the
/// largest load, over the same grains: those whose stress is known in each.
struct FilmStresses {
  std::vector<GrainStresses> sources;
  std::vector<std::uint8_t> considered;  ///< 1 for grains that count; empty without sources
};
/// Of these grains those count that `considered` has, as the film's texture says; all of them where it has fewer than
/// three.
FilmStresses film_stresses(const FilmResult& result, const std::vector<std::uint8_t>& considered);

/// How two stresses of the same grains agree.
struct Agreement {
  statistics::Relation relation;                ///< of the film (y) to the simulation (x)
  double rms = statistics::unknown;             ///< root mean square difference, Pa
  double rms_sigma_norm = statistics::unknown;  ///< likewise of each over its mean
};
/// Over grains that are known in both and where `counts` is 1; unknown for fewer than two.
Agreement agreement(const std::vector<double>& film, const std::vector<double>& simulation,
                    const std::vector<std::uint8_t>& counts);
/// As all results call them: count, correlation, slope, rms_Pa, rms_sigma_norm.
Numbers numbers(const Agreement& agreement);
/// How the film agrees with one source of the simulation: "all" first, then by material where there are several; sets
/// of fewer than three grains are left out.
Numbers agreement_of(const Packing& packing, const FilmStresses& stresses, const GrainStresses& simulation);

}  // namespace arenite::inference
