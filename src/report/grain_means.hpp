#pragma once
#include <cstdint>
#include <vector>

#include "model/phase_map.hpp"
#include "model/stress_field.hpp"

namespace arenite::report {

/// Nodes, centre and mean stress of every grain of a map, over all of its nodes; stresses empty without a field.
struct GrainMeans {
  std::vector<std::uint32_t> nodes;
  std::vector<double> x, y;         ///< m, from the lower left corner of the map
  std::vector<double> xx, yy, xy;   ///< Pa
};

GrainMeans grain_means(const PhaseMap& map, const StressField& field);

}  // namespace arenite::report
