#pragma once
#include "core/threads.hpp"
#include "geometry/cell_grid.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Disks whose partners are sought in one go.
inline constexpr std::size_t disks_of_block = 64;

/// Sorts the disks by cell, wraps them into a periodic cell, makes the ghosts and lists every pair (and wall) closer than the skin. What touching
/// pairs remember is kept. Throws CannotGoOn, naming grain and step, if a grain has left the walls, gone through a boundary, or a coordinate is not finite.
template <int D> void rebuild_list(SampleIn<D>& sample, const ThreadPool& pool = ThreadPool());

/// Lists the pairs at the records' present order and places without sorting; what rebuild_list does at its end, and what a restored sample needs.
template <int D> void list_contacts(SampleIn<D>& sample, const ThreadPool& pool = ThreadPool());

/// Puts what has crossed a periodic edge back at the opposite one. Its own velocity is without the affine motion and does not change, that which the
/// forces see does; across the edges of a sheared cell both go on as the image does that comes in there.
template <int D> void wrap_over_sides(SampleIn<D>& sample, double mass, Vec<D>& place, double& own_x, Vec<D>& seen);

/// Finds the inner numbers of the grains that go with rough walls.
void number_held(Sample& sample);

/// Puts the grains that go with rough walls where these are, with their velocity.
void hold_grains(Sample& sample);

/// Cells as wide as the list reaches, over the frame; beyond an open side as far as there are disks, but at most the frame's own size.
template <int D> geometry::Box<D> room_of(const SampleIn<D>& sample);
template <int D> geometry::CellGrid<D> cells_of(const SampleIn<D>& sample) { return {room_of(sample), reach_of(sample)}; }

/// Copies the sources of ghosts to their images (positions and seen velocities).
template <int D> void refresh_ghosts(SampleIn<D>& sample);

/// Grains a and b (caller's indices) were declared glued: by name, or by their zones where no pair is named.
template <int D> bool is_marked_as_glued(const SampleIn<D>& sample, std::int32_t a, std::int32_t b);

/// What the laws need of two disks.
template <int D> Coefficients pair_coefficients(const SampleIn<D>& sample, const GrainRecord<D>& a, const GrainRecord<D>& b);

/// Decides anew which listed pairs attract, after glue was switched on or off. Where bonds break for good, the glued pairs that touch now (to a
/// millionth of their radii) are the bonds there are.
template <int D> void bond_touching_pairs(SampleIn<D>& sample);

}  // namespace arenite::dem
