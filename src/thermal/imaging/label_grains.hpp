#pragma once
#include <cstdint>
#include <vector>

#include "model/phase_map.hpp"

/// Grains in pictures.
namespace arenite::imaging {

/// What one grain is, in a map without labels.
enum class Labelling {
  components,  ///< particle nodes that hang together by their four neighbours
  watershed    ///< the same, cut at necks: touching grains come apart
};

struct LabelOptions {
  Labelling way = Labelling::components;
  /// Of the watershed: two summits of the distance transform are one grain if the way between them does not drop by
  /// more than this below the lower one (its h-maxima), nodes. More joins what a rough outline would cut.
  double smoothing = 1;
};

/// Labels the particles of a map anew, in the order of their first node, all of class `none`. The same map and options
/// give the same labels. Throws InputError for a smoothing that is negative or no number.
void label_grains(PhaseMap& map, const LabelOptions& options);

/// Squared distance, in nodes, from each particle node to the nearest node that is none; 0 where there is no particle.
/// Exact (A. Meijster, J. Roerdink, W. Hesselink, 2000). What lies outside the map is not known and does not count; a
/// map without any other phase has the largest number everywhere.
std::vector<std::int32_t> squared_distance(const PhaseMap& map);

}  // namespace arenite::imaging
