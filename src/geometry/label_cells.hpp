#pragma once
#include <cstdint>
#include <vector>

#include "geometry/squared_distance.hpp"

namespace arenite::geometry {

/// What one grain is, in a map without labels.
enum class Labelling {
  components,  ///< particle cells that hang together by their sides
  watershed    ///< the same, cut at necks: touching grains come apart
};

struct LabelOptions {
  Labelling way = Labelling::components;
  /// Of the watershed: two summits of the distance transform are one grain if the way between them does not drop by
  /// more than this below the lower one (its h-maxima), cells. More joins what a rough outline would cut.
  double smoothing = 1;
};

/// Grains by the cells they own.
struct CellLabels {
  std::vector<std::int32_t> label;  ///< of each cell, numbered in the order of first cells; -1 outside
  std::int32_t count = 0;
};

/// The same cells and options give the same labels. Throws InputError for a smoothing that is negative or no number.
CellLabels label_cells(const Cells& cells, const std::vector<std::uint8_t>& inside, const LabelOptions& options);

}  // namespace arenite::geometry
