#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec2.hpp"
#include "model/phase_map.hpp"
#include "model/stress_field.hpp"
#include "statistics/estimate.hpp"

namespace arenite::stress {

using statistics::ByName;
using statistics::Curve;
using statistics::Estimate;
using statistics::TensorEstimate;
using statistics::unknown;

/// Mean stress of every grain over its nodes, Pa, tension positive; arrays as long as PhaseMap::grain_class.
struct GrainStresses {
  std::vector<std::int64_t> nodes;       ///< in the map, surface nodes included; 0: the grain has none
  std::vector<std::uint8_t> whole;       ///< 1 where no node lies on the map's edge or in a clamp row
  std::vector<Vec2> centre;              ///< of its nodes, m from the map's lower left corner
  std::vector<Tensor2> stress;           ///< zero without nodes
  ByName<TensorEstimate> mean;           ///< of whole grains, each grain alike: "all", "large", "small"
};

/// Mean stress tensors of the grains of a map, and means by class with errors over blocks x blocks of the map.
GrainStresses measure_grains(const PhaseMap& map, const StressField& field, int clamp_rows, int blocks);

/// How two stresses of the same grains agree, each over the mean of its own set: slope and rms of
/// (field over its mean) against (contacts over their mean).
struct Agreement {
  std::size_t grains = 0;
  Estimate correlation;                  ///< Pearson's; error by leaving out one grain at a time
  Estimate slope;
  double rms = unknown;                  ///< of the difference
};

struct GrainComparison {
  ByName<Agreement> yy, hydrostatic;     ///< "all", "large", "small"
};

/// Compares the mean stresses of whole grains with stresses of the same grains from contact forces (one tensor a grain
/// of the map, any unit; texture's per_grain.sigma). Grains without contact stress (zero or NaN) are left out. Throws
/// InputError where the numbers of grains differ.
GrainComparison compare(const PhaseMap& map, const GrainStresses& grains, const std::vector<Tensor2>& contact_stress);

}  // namespace arenite::stress
