#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "grains/texture/texture.hpp"
#include "model/film_result.hpp"
#include "statistics/correlation.hpp"
#include "statistics/numbers.hpp"

namespace arenite::workflow {

/// Stress of the grains from one source, Pa, tension positive, over the mean of the grains that count.
struct GrainStresses {
  std::string source;                 ///< "film", "simulation_peak_to_peak", "simulation_state"
  std::vector<double> sigma_hyd;      ///< one a grain; NaN where it is not known in every source
  std::vector<double> sigma_norm;     ///< likewise
  double mean = statistics::unknown;  ///< that sigma_norm is over, Pa
  Numbers statistics;                 ///< "sigma_norm" as texture::numbers has it; {} where nothing can be measured
};

/// The stresses of a film and, where there is one, of its companion simulation, peak to peak and as the state at the largest load. All three are taken over the same grains: those whose stress is
/// known in each. Grains count as texture has them (without a border where that would leave none).
struct FilmStresses {
  std::vector<GrainStresses> sources;
  std::vector<std::uint8_t> considered;  ///< 1 for grains that count; empty without sources
};

FilmStresses film_stresses(const FilmResult& result, const texture::Options& options);

/// How the film (y) follows its companion simulation (x) over the grains that are known in both.
struct StressRelation {
  std::string set;  ///< "all", or a material
  statistics::Relation relation;
  double rms = statistics::unknown;       ///< root mean square of the difference, Pa
  double rms_norm = statistics::unknown;  ///< likewise of sigma_norm
};

/// "all" first, then by material where there are several; sets of less than three grains are left out.
std::vector<StressRelation> stress_relations(const Packing& packing, const GrainStresses& film, const GrainStresses& simulation);

}  // namespace arenite::workflow
