#pragma once
#include <cstdint>

#include "model/domain.hpp"
#include "model/grains.hpp"
#include "grains/packing/relax.hpp"

namespace arenite::packing {

/// Height at which the grains fill `solid_fraction` of a box of that width, m.
double height_for(const Grains& grains, double width, double solid_fraction);

/// Random places, then relax: no overlap larger than 1e-4 of the radii is left. Works up to a solid fraction of about
/// 0.82; beyond it disks jam, and InputError names the fraction. Same seed: same packing.
RelaxReport fill_at_random(Grains& grains, const Domain& domain, std::uint64_t seed);

/// Triangular lattice, row on row from the bottom, as a careful hand stacks cylinders; sites as wide as the largest
/// grain. Returns the height that is filled, m. Throws InputError where the domain is too narrow for a row.
double fill_lattice(Grains& grains, const Domain& domain);

}  // namespace arenite::packing
