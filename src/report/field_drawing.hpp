#pragma once
#include "model/result.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {

/// A cemented sample as JSON for a figure: `size` of the picture in mm, `nodes` across and up, from the top row on runs
/// of equal kind, [NodeKind, how many, ...].
Numbers phases_drawing(const FieldResult& sample);

/// Vertical stress of the nodes in and about the large grain (any grain, where there are no classes) whose middle is
/// nearest to the sample's: as above, with `stress` over the mean of all nodes that are not void, null in the void, and
/// `edges` between nodes of different grains or of grain and matrix, [x, y, 1 where it is upright] in nodes from the
/// upper left corner.
Numbers zoom_drawing(const FieldResult& load);

/// A test to failure: its phases as above, and `cracks`, the middles of its broken bonds in the order of breaking: `x`
/// and `y` in nodes of the picture from its upper left corner, `type` 1 matrix, 2 interface, 3 particle. InputError
/// where nothing broke.
Numbers cracks_drawing(const FieldResult& test);

}  // namespace arenite::report
