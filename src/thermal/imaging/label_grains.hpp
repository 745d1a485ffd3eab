#pragma once
#include <cstdint>
#include <vector>

#include "geometry/label_cells.hpp"
#include "model/phase_map.hpp"

/// Grains in pictures.
namespace arenite::imaging {

using geometry::Labelling, geometry::LabelOptions;

/// Labels the particles of a map anew, in the order of their first node, all of class `none`. The same map and options
/// give the same labels. Throws InputError for a smoothing that is negative or no number.
void label_grains(PhaseMap& map, const LabelOptions& options, bool periodic = false);

/// Squared distance, in nodes, from each particle node to the nearest node that is none, as of
/// geometry::squared_distance.
std::vector<std::int32_t> squared_distance(const PhaseMap& map);

}  // namespace arenite::imaging
