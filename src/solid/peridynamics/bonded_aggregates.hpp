#pragma once
#include <cstdint>
#include <vector>

#include "solid/peridynamics/bonds.hpp"
#include "solid/statics/aggregates.hpp"

namespace arenite::peridynamics {

/// Aggregates that bonds hold together; rows with both components prescribed belong to nobody (`prescribed` has one
/// entry a row).
Aggregates cut_into_aggregates(const PhaseMap& map, const Bonds& bonds, const std::vector<std::uint8_t>& prescribed);

}  // namespace arenite::peridynamics
