#pragma once
#include <array>

#include "solid/peridynamics/options.hpp"

namespace arenite::peridynamics {

/// Critical stretch by BondType, the lower of those that toughness and strength give on a grid of this spacing; that of
/// `no_bond` is 0. Throws InputError for a toughness or strength that is not positive.
template <int D> std::array<double, 4> critical_stretches(const DamageOptionsIn<D>& options, double dx);

}  // namespace arenite::peridynamics
