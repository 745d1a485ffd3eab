#pragma once
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "model/phase_map.hpp"
#include "statistics/numbers.hpp"

namespace arenite::stress {

/// Mean stress of every grain over its nodes, Pa, tension positive; arrays as long as PhaseMap::grain_class.
struct GrainStresses {
  std::vector<std::int64_t> nodes;                      ///< in the map, surface nodes included; 0: the grain has none
  std::vector<std::uint8_t> whole;                      ///< 1 where no node lies on the map's edge or in a clamp row
  std::vector<Vec2> centre;                             ///< of its nodes, m from the map's lower left corner
  std::vector<Tensor2> stress;                          ///< zero without nodes
  statistics::ByName<statistics::TensorEstimate> mean;  ///< of whole grains, each grain alike: "all", "large", "small"
};

/// Mean stress tensors of the grains of a map, and means by class with errors over so many columns from clamp to clamp.
/// Without a field (of size 0) nodes and centres alone are known.
GrainStresses measure_grains(const PhaseMap& map, const StressField& field, int clamp_rows, int columns);

/// sigma_yy at the nodes of each grain, Pa, of the whole map; no number where a grain has none.
struct GrainExtremes {
  std::vector<double> least, most;
};
GrainExtremes extremes_of(const PhaseMap& map, const StressField& field);

/// How many are whole, the means, and the rows by grain.
Numbers numbers(const GrainStresses& grains);

/// How the mean stresses of whole grains agree with those of the same grains from contact forces (one tensor a grain of
/// the map, any unit, such as texture's per_grain.sigma): of "sigma_yy" and "sigma_hyd", and of "all", "large" and
/// "small" grains, Pearson's correlation, and slope and root mean square difference of (field over its mean) against
/// (contacts over their mean). Grains without contact stress (zero or NaN) are left out. Throws InputError where the
/// numbers of grains differ.
Numbers compare(const PhaseMap& map, const GrainStresses& grains, const std::vector<Tensor2>& contact_stress);

}  // namespace arenite::stress
