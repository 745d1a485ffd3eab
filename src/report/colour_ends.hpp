#pragma once
#include <utility>
#include <vector>

#include "grains/fields/coarse_layers.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {

/// Where the colours of a picture end, on the page and in print, and what share of its values lies beyond either end:
/// of the nodes of a field, of the pixels of a film, of the cells of coarse-grained fields.
using ColourEnds = std::pair<double, double>;
inline constexpr double nodes_beyond = 0.001, pixels_beyond = 0.01, cells_beyond = 0.01;

/// Ends beyond which this share of the values lies, of those that are known; {0, 0} where there is none.
ColourEnds ends_of(std::vector<double> values, double share);

/// Of a layer's values in one state, where any grain is in reach: both ways as far about 0, or from 0 where it does not
/// begin at its least.
template <int D>
ColourEnds ends_of(const fields::CoarseLayerIn<D>& layer, const fields::CoarseFieldsIn<D>& fields,
                   std::vector<double> values);

Numbers numbers_of(const ColourEnds& ends);

}  // namespace arenite::report
