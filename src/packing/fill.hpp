#pragma once
#include <cstdint>

#include "model/domain.hpp"
#include "model/grains.hpp"
#include "packing/relax.hpp"

namespace arenite::packing {

/// A box of the given width whose height makes the grains fill `solid_fraction` of it, from (0, 0).
/// Walls in the directions that are not periodic.
Domain box_for(const Grains& grains, double width, double solid_fraction, bool periodic_x, bool periodic_y, double thickness);

/// Random places, then relax: no overlap larger than 1e-4 of the radii is left. Works up to a solid fraction of about
/// 0.82; beyond it disks jam, and InputError names the fraction. Same seed: same packing.
RelaxReport fill_at_random(Grains& grains, const Domain& domain, std::uint64_t seed);

/// Triangular lattice, row on row from the bottom, as a careful hand stacks cylinders; sites as wide as the largest
/// grain. Returns the height that is filled, m.
double fill_lattice(Grains& grains, const Domain& domain);

}  // namespace arenite::packing
