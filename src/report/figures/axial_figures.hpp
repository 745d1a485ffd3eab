#pragma once
#include "grains/fields/test_curves.hpp"
#include "report/figures/stage_figures.hpp"

namespace arenite::report::figures {

/// Stress against strain with the strength and the slope that is the modulus, and, of grains with bonds, those that
/// broke. Panels are like `plain`, which has the strain's axis.
Drawing uniaxial_drawing(const fields::TestCurves& curves, const Panel& plain, const History& history);
/// Stresses along the axis and across it, and their ratio.
Drawing oedometer_drawing(const fields::TestCurves& curves, const StageData& data);

}  // namespace arenite::report::figures
