#pragma once
#include <cstdint>

#include "model/packing.hpp"

namespace arenite::packing {

/// What a relaxation found and did; overlaps are relative to the mean radius of the two grains (a wall counts as the
/// grain).
struct RelaxReport {
  double overlap_before = 0;  ///< largest
  double overlap_after = 0;   ///< largest
  double largest_move = 0;    ///< m
  int iterations = 0;
};

/// Pushes grains apart until no overlap is larger than `tolerance` (relative), by following the gradient of the overlap
/// energy sum of h^2 downhill with inertia (FIRE: E. Bitzek et al., PRL 97, 170201, 2006). Geometry only: sizes count,
/// materials do not. Ends at `max_iterations` in a jammed sample; the report says what is left.
template <int D = 2>
RelaxReport relax(GrainsIn<D>& grains, const DomainIn<D>& domain, double tolerance = 1e-4, int max_iterations = 20'000);

/// Height at which the grains fill `solid_fraction` of a box of that width, m.
double height_for(const Grains& grains, double width, double solid_fraction);
/// Of spheres in a box of that width and depth.
double height_for(const GrainsIn<3>& grains, double width, double depth, double solid_fraction);

/// Random places, then relax: no overlap larger than 1e-4 of the radii is left. Works up to a solid fraction of about
/// 0.82 of disks and 0.62 of spheres; beyond it they jam, and InputError names the fraction. Same seed: same packing.
template <int D = 2> RelaxReport fill_at_random(GrainsIn<D>& grains, const DomainIn<D>& domain, std::uint64_t seed);

/// Triangular lattice, row on row from the bottom, as a careful hand stacks cylinders; sites as wide as the largest
/// grain. Returns the height that is filled, m. Throws InputError where the domain is too narrow for a row.
double fill_lattice(Grains& grains, const Domain& domain);

/// Face-centred cubic, layer on layer of squares from the bottom, as cannonballs are stacked; else as in the plane. A
/// periodic cell of whole sites is a crystal without faults, where the number of layers is even.
double fill_lattice(GrainsIn<3>& spheres, const DomainIn<3>& domain);

}  // namespace arenite::packing
