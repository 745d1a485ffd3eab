#pragma once
#include <optional>

#include "model/result.hpp"
#include "statistics/columns.hpp"

namespace arenite::fields {

/// Curves of a stage of spheres, whichever test it is, row by row of its history: `time` since the first row, s, and
/// those of triaxial_curves along that axis, or of shear_columns. Nothing of a stage that is neither.
std::optional<statistics::Columns> curves_in_space(const SphereResult& result, int axis);

/// The same along the axis that the stage was asked to close. Throws InputError for a stage that is neither.
statistics::Columns curves_in_space(const SphereResult& result);

}  // namespace arenite::fields
