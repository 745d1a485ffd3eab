#pragma once
#include <optional>

#include "model/result.hpp"
#include "statistics/columns.hpp"

namespace arenite::fields {

/// Curves of spheres that are sheared, by two sides that slide or with their cell, row by row of the history of their
/// stage: `shear_strain` since its first row, `tau` and `normal_stress`, Pa, on the two sheared sides, `mu`,
/// `volumetric_strain`, `solid_fraction` and `inertial_number`, all as of disks (loading.hpp). Nothing of another
/// stage.
std::optional<statistics::Columns> shear_columns(const SphereResult& result);

}  // namespace arenite::fields
