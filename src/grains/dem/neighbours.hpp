#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/threads.hpp"
#include "geometry/cell_grid.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Of lists, in mean radii: that of disks is the largest.
inline constexpr double largest_skin = 0.15, smallest_skin = 0.02;

/// Sorts the disks by cell, wraps them into a periodic cell, makes the ghosts and lists every pair (and wall) closer
/// than the skin. What touching pairs remember is kept. Throws CannotGoOn, naming grain and step, if a grain has left
/// the walls, gone through a boundary or into another grain beyond that one's centre, or a coordinate is not finite.
template <int D> void rebuild_list(SampleIn<D>& sample, const ThreadPool& pool = ThreadPool());

/// The same in two steps, between which disks may come and go: the first looks at the list that ends; `renumbered` then
/// says which number each disk has in that one, new_disk of one that has none. Empty: its own.
template <int D> void end_list(SampleIn<D>& sample);
template <int D>
void begin_list(SampleIn<D>& sample, const ThreadPool& pool, const std::vector<std::int32_t>& renumbered);
inline constexpr std::int32_t new_disk = -1;

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

/// Lists the contacts anew after something came or went; springs stay as they are. What springs hold of a body that is
/// gone, or that came into the grains, is work of the sides.
template <int D> void list_anew(SampleIn<D>& sample, const ThreadPool& pool);

}  // namespace arenite::dem
