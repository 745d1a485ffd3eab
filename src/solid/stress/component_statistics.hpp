#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "solid/stress/selection.hpp"
#include "statistics/numbers.hpp"

namespace arenite::stress {

/// A stress at a node, Pa.
using StressAt = std::function<double(std::size_t node)>;

/// Statistics of one component of stress by set: "all", "particle", "large", "small", "matrix". Not known where it is
/// zero in every node. Stresses are divided by the mean over the nodes, or over the whole area.
Numbers component_statistics(const Selection& selection, const std::string& name, const StressAt& stress,
                             bool mean_over_area, std::vector<std::string>& notes);

}  // namespace arenite::stress
