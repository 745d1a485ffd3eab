#pragma once
#include <optional>

#include "grains/dem/stage.hpp"
#include "model/result.hpp"
#include "statistics/columns.hpp"

namespace arenite::fields {

/// The axis along which a stage closes or opens sides at a speed, of its own or of a programme, if it is the only one;
/// -1 else.
int closing_axis(const dem::Stage& stage);

/// Curves of a stage of spheres that closes along that axis (closing_axis, Asked::closes), row by row of its history:
/// `axial_strain` and `volumetric_strain` since Asked::box, compression positive, `axial_stress`, Pa, `p` and `q`, the
/// mean of the three stresses on the sides and the axial one less the mean of the others, Pa, `q_over_p`,
/// `solid_fraction` and, of a confined one, `inertial_number`. Nothing of another stage.
std::optional<statistics::Columns> triaxial_curves(const SphereResult& result, int axis);

/// Whether the sides across the axis press, too; else it is a test of uniaxial compression.
bool is_confined(const statistics::Columns& curves);

}  // namespace arenite::fields
