#pragma once
#include <optional>

#include "grains/fields/test_curves.hpp"
#include "model/result.hpp"

namespace arenite::fields {

/// A stage of spheres as a test: one that closes or opens along an axis (triaxial.hpp), or is sheared
/// (shear_in_space.hpp). Strains and ratios of confined and of sheared samples are how large they are. Nothing that
/// strains by less than 0.2 % or is not pressed.
std::optional<TestCurves> test_curves(const SphereResult& stage);

}  // namespace arenite::fields
