#pragma once
#include "core/threads.hpp"
#include "geometry/cell_grid.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Disks whose partners are sought in one go.
inline constexpr std::size_t disks_of_block = 64;

/// Sorts the disks by cell, wraps them into a periodic cell, makes the ghosts and lists every pair (and wall) closer than the skin. What touching
/// pairs remember is kept. Throws CannotGoOn, naming grain and step, if a grain has left the walls, gone through a boundary, or a coordinate is not finite.
void rebuild_list(Sample& sample, const ThreadPool& pool = ThreadPool());

/// Lists the pairs at the records' present order and places without sorting; what rebuild_list does at its end, and what a restored sample needs.
void list_contacts(Sample& sample, const ThreadPool& pool = ThreadPool());

/// Puts what has crossed a periodic edge back at the opposite one. Its own velocity is without the affine motion and does not change, that which the
/// forces see does; across the edges of a sheared cell both go on as the image does that comes in there.
void wrap_over_sides(Sample& sample, double mass, Vec2& place, double& own_x, Vec2& seen);

/// Finds the inner numbers of the grains that go with rough walls.
void number_held(Sample& sample);

/// Puts the grains that go with rough walls where these are, with their velocity.
void hold_grains(Sample& sample);

/// How far a disk may be from its place in the list, less the affine motion of the cell, before the list may miss a contact, m; 0 or less if the
/// walls or the cell have moved too far for that.
double list_leeway(const Sample& sample);

/// Cells as wide as the list reaches, over the frame; beyond an open side as far as there are disks, but at most the frame's own size.
geometry::Box<2> room_of(const Sample& sample);
inline geometry::CellGrid<2> cells_of(const Sample& sample) { return {room_of(sample), reach_of(sample)}; }

/// Copies the sources of ghosts to their images (positions and seen velocities).
void refresh_ghosts(Sample& sample);

/// Grains a and b (caller's indices) were declared glued: by name, or by their zones where no pair is named.
bool is_marked_as_glued(const Sample& sample, std::int32_t a, std::int32_t b);

/// What the laws need of two disks.
Coefficients pair_coefficients(const Sample& sample, const DiskRecord& a, const DiskRecord& b);

/// Decides anew which listed pairs attract, after glue was switched on or off. Where bonds break for good, the glued pairs that touch now (to a
/// millionth of their radii) are the bonds there are.
void bond_touching_pairs(Sample& sample);

}  // namespace arenite::dem
