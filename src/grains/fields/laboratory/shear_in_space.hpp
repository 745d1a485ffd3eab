#pragma once
#include <optional>

#include "grains/fields/test_curves.hpp"
#include "model/result.hpp"
#include "statistics/columns.hpp"

namespace arenite::fields {

/// Curves of spheres that are sheared, by two sides that slide or with their cell, row by row of the history of their
/// stage: `shear_strain` since its first row, `tau` and `normal_stress`, Pa, on the two sheared sides, `mu`,
/// `volumetric_strain`, `solid_fraction` and `inertial_number`, all as of disks (loading.hpp). Nothing of another
/// stage.
std::optional<statistics::Columns> shear_columns(const SphereResult& result);

/// The same as a test; nothing that strains by less than 0.2 % or is not pressed.
std::optional<TestCurves> shear_in_space(const SphereResult& result);

/// "critical_state" of that test, if it is reached (test_curves.hpp). Empty of another stage, and of one that closes
/// along an axis, too (triaxial.hpp).
Numbers shear_numbers(const SphereResult& result);

}  // namespace arenite::fields
