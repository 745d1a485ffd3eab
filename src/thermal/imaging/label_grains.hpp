#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/phase_map.hpp"

namespace arenite::imaging {

/// What one grain is, in a map without labels.
enum class Labelling {
  components,  ///< particle nodes that hang together by their four neighbours
  watershed    ///< the same, cut at necks: touching grains come apart
};

struct LabelOptions {
  Labelling way = Labelling::components;
  /// Of the watershed: two summits of the distance transform are one grain if the way between them does not drop by more
  /// than this below the lower one (its h-maxima), nodes. More joins what a rough outline would cut.
  double smoothing = 1;
};

struct LabelReport {
  std::int32_t grains = 0;
  double largest_share = 0;  ///< of the particle nodes in the largest grain
};

/// Labels the particles of a map anew, in the order of their first node, all of class `none`. The same map and options
/// give the same labels. Throws InputError for a smoothing that is negative or no number.
LabelReport label_grains(PhaseMap& map, const LabelOptions& options);

/// The two ways: a label for each particle node, equal within a grain and otherwise arbitrary, -1 elsewhere.
std::vector<std::int32_t> connected_particles(const PhaseMap& map);
std::vector<std::int32_t> watershed(const PhaseMap& map, double smoothing);

}  // namespace arenite::imaging
