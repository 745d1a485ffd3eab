#pragma once
#include "grains/fields/test_curves.hpp"
#include "report/figures/stage_figures.hpp"

namespace arenite::report::figures {

/// Stress against strain with the strength and the slope that is the modulus, and, of grains with bonds, those that
/// broke.
Drawing uniaxial_drawing(const fields::TestCurves& curves, const StageData& data);
/// Stresses along the axis and across it, and their ratio.
Drawing oedometer_drawing(const fields::TestCurves& curves, const StageData& data);
/// Of spheres that are sheared mu, of those that are closed upon along one axis q/p with its peak, each with its
/// critical state, and the volumetric strain; of uniaxial compression the stress. Nothing of another stage.
Drawings drawing_of_test(const SphereResult& stage);

}  // namespace arenite::report::figures
