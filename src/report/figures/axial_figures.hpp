#pragma once
#include "grains/fields/test_curves.hpp"
#include "report/figures/stage_figures.hpp"

namespace arenite::report::figures {

/// Stress against strain with the strength and the slope that is the modulus, and, of grains with bonds, those that
/// broke.
Drawing uniaxial_drawing(const fields::TestCurves& curves, const StageData& data);
/// Stresses along the axis and across it, and their ratio.
Drawing oedometer_drawing(const fields::TestCurves& curves, const StageData& data);
/// Of spheres: q/p with its peak and its critical state, and the volumetric strain. Nothing of another stage than a
/// test that closes along one axis.
Drawings triaxial_drawing(const SphereResult& stage);

}  // namespace arenite::report::figures
