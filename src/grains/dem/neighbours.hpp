#pragma once
#include <algorithm>
#include <utility>

#include "core/threads.hpp"
#include "geometry/cell_grid.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Disks whose partners are sought in one go.
inline constexpr std::size_t disks_of_block = 64;

/// Sorts the disks by cell, wraps them into a periodic cell, makes the ghosts and lists every pair (and wall) closer
/// than the skin. What touching pairs remember is kept. Throws CannotGoOn, naming grain and step, if a grain has left
/// the walls, gone through a boundary or into another grain beyond that one's centre, or a coordinate is not finite.
template <int D> void rebuild_list(SampleIn<D>& sample, const ThreadPool& pool = ThreadPool());

/// Lists the pairs at the records' present order and places without sorting; what rebuild_list does at its end, and
/// what a restored sample needs.
template <int D> void list_contacts(SampleIn<D>& sample, const ThreadPool& pool = ThreadPool());

/// Puts what has crossed a periodic edge back at the opposite one. Its own velocity is without the affine motion and
/// does not change, that which the forces see does; across the edges of a sheared cell both go on as the image does
/// that comes in there.
template <int D> void wrap_over_sides(SampleIn<D>& s, double mass, Vec<D>& place, double& own_x, Vec<D>& seen) {
  const CellMotion<D> cell = cell_motion(s.domain);
  const std::int32_t rows = s.domain.cell_of(place).y;
  const Vec<D> wrapped = s.domain.wrapped(place);
  if (const double faster = -rows * s.shear_rate * s.domain.extent(1); faster != 0) {
    if (s.integration.track_energy) s.tally.work_walls += 0.5 * mass * faster * (2 * own_x + faster);
    own_x += faster;
    seen.x += faster;
  }
  place.x -= rows * s.domain.tilt;
  for (int axis = 0; axis < D; ++axis)
    if (s.domain.periodic[axis]) seen[axis] += cell.along[axis].at(wrapped[axis]) - cell.along[axis].at(place[axis]);
  place = wrapped;
}

/// Finds the inner numbers of the grains that go with rough walls.
void number_held(Sample& sample);

/// Puts the grains that go with rough walls where these are, with their velocity.
void hold_grains(Sample& sample);

/// Cells as wide as the list reaches, over the container; beyond an open side as far as there are disks, but at most
/// the container's own size.
template <int D> geometry::Box<D> room_of(const SampleIn<D>& s) {
  Vec<D> edge[] = {s.domain.corner(0), s.domain.corner(1)};
  for (int side = 0; side < sides_in<D>; ++side) {
    if (!s.wall[side].open) continue;
    double beyond = 0;
    for (std::size_t k = 0; k < s.count; ++k) beyond = std::max(beyond, -s.domain.depth(side, s.record[k].place));
    edge[side % 2][axis_of(side)] -= inward_sign(side) * std::min(beyond, s.domain.extent(axis_of(side)));
  }
  return {edge[0], edge[1] - edge[0]};
}
template <int D> geometry::CellGrid<D> cells_of(const SampleIn<D>& sample) {
  return {room_of(sample), reach_of(sample)};
}

/// Copies the sources of ghosts to their images (positions and seen velocities).
template <int D> void refresh_ghosts(SampleIn<D>& sample);

/// Grains a and b (caller's indices) were declared glued: by name, or by their zones where no pair is named.
template <int D> bool is_marked_as_glued(const SampleIn<D>& s, std::int32_t a, std::int32_t b) {
  const auto& zone = s.start.grains.zone;
  const auto& glued = s.contact.glued_pairs;  // sorted, low index first
  if (glued.empty()) return zone[a] > 0 && zone[b] > 0;
  a = grain_of(s, a), b = grain_of(s, b);
  return std::binary_search(glued.begin(), glued.end(), std::pair{std::min(a, b), std::max(a, b)});
}

/// Glued grains part for good.
template <int D> bool bonds_break(const SampleIn<D>& s) {
  return s.contact.adhesion.visit([](const auto& law) { return law.breaks; });
}

/// Whether grains a and b (caller's indices) attract each other.
template <int D> bool is_glued(const SampleIn<D>& s, std::int32_t a, std::int32_t b) {
  if (!s.glue || !s.contact.adheres()) return false;
  return bonds_break(s) ? std::binary_search(s.live_bonds.begin(), s.live_bonds.end(), pair_key(a, b))
                        : is_marked_as_glued(s, a, b);
}

/// What the laws need of two disks.
template <int D>
Coefficients pair_coefficients(const SampleIn<D>& s, const GrainRecord<D>& a, const GrainRecord<D>& b) {
  return s.coefficients.pair(a, b, is_glued(s, a.grain, b.grain));
}

/// Decides anew which listed pairs attract, after glue was switched on or off. Where bonds break for good, the glued
/// pairs that touch now (to a millionth of their radii) are the bonds there are.
template <int D> void bond_touching_pairs(SampleIn<D>& s) {
  s.live_bonds.clear();
  if (s.glue && bonds_break(s)) {
    for (std::size_t p = 0; p < s.list.pairs; ++p) {
      const auto &a = s.record[s.list.i[p]], &b = s.record[s.list.j[p]];
      const double reach = (1 + 1e-6) * (a.radius + b.radius);
      const auto d = a.place - b.place;
      if (dot(d, d) < reach * reach && is_marked_as_glued(s, a.grain, b.grain)) s.live_bonds.push_back(slot_key(s, p));
    }
    std::sort(s.live_bonds.begin(), s.live_bonds.end());
  }
  for (std::size_t p = 0; p < s.list.pairs; ++p)
    s.list.strength[p] = pair_coefficients(s, s.record[s.list.i[p]], s.record[s.list.j[p]]).strength;
}

}  // namespace arenite::dem
