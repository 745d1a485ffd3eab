#pragma once
#include <functional>
#include <string_view>
#include <vector>

#include "report/figures/drawing.hpp"

namespace arenite::report::figures {

const Head& grain_scatter_head();

/// Numbers of the grains of a state by their names (texture/grain_quantities.hpp); empty where the state has them not.
using GrainNumbers = std::function<std::vector<double>(std::string_view name)>;

/// The numbers of the grains of a run's last state, any against any other: in units that suit this state, and with
/// those across and up that its grains differ in. Nothing of fewer than two grains.
Drawings grain_scatter(const GrainNumbers& last);

}  // namespace arenite::report::figures
