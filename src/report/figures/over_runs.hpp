#pragma once
#include <string>
#include <vector>

#include "grains/fields/over_runs.hpp"
#include "report/figures/drawing.hpp"

namespace arenite::report::figures {

/// Figures of several results, each one point: rheology, critical states, and the laws of flows; by their ids those of
/// campaign::StudyKind.
const std::vector<Row<std::vector<fields::AnyTest>>>& figures_over_runs();

/// The row of this id. Throws InputError for another.
const Row<std::vector<fields::AnyTest>>& figure_over_runs(const std::string& id);

}  // namespace arenite::report::figures
