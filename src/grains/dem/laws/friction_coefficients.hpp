#pragma once
#include <optional>

#include "core/parameters.hpp"

namespace arenite::dem {

/// The keys of Coulomb's coefficients, between grains and at the walls, for whatever has them.
void declare_friction(ParameterVisitor& visitor, double& friction, std::optional<double>& wall_friction);

}  // namespace arenite::dem
