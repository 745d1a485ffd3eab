#pragma once
#include <cstdint>
#include <vector>

#include "grains/dem/forces.hpp"

namespace arenite::dem {

/// The boundary of a partner that is an element of one.
template <int D> const ElementIn<D>& touched_element(const SampleIn<D>& s, std::int32_t j) {
  return the<BoundariesIn<D>>(s).element[static_cast<std::size_t>(element_of<D>(j))];
}
template <int D> std::size_t boundary_index(const SampleIn<D>& s, std::int32_t j) {
  return static_cast<std::size_t>(touched_element(s, j).boundary);
}
template <int D> const BoundaryIn<D>& boundary_of(const SampleIn<D>& s, std::int32_t j) {
  return s.domain.boundaries[boundary_index(s, j)];
}

/// What is wrong with a boundary: too few points, points that coincide, segments longer than a periodic cell.
void check_shape(Problems& problems, const Domain& domain, const Boundary& boundary);

/// What disks can touch of the domain's boundaries, in the order of their numbers.
std::vector<Element> elements_of(const Domain& domain);

/// Whether the elements of two partners follow each other along one boundary, perhaps with a third between them that
/// was skipped within a step.
bool are_neighbours(const Sample& sample, std::int32_t j, std::int32_t k);

/// Whether an open boundary ends at an image of the point that it begins at, and so has no ends.
bool goes_through_sides(const Domain& domain, const Boundary& boundary);

/// Whether a point of a boundary juts out towards a place near it, as seen from there: an end, or an angle above 180
/// degrees. Where the place lies in a corner, or the boundary goes straight on, sides of polygons cannot touch the
/// point.
bool juts_out(const Domain& domain, const Boundary& boundary, std::size_t point, Vec2 place);

/// Finds the elements of present boundaries nearer to a disk's rim than the skin, in the order of their numbers.
void find_near_elements(const Sample& sample, const DiskRecord& disk, std::vector<std::int32_t>& near);

/// A disk and an element of a boundary. A segment is touched where the centre's foot on its line lies strictly within
/// it, an end point where the centre lies beyond the segments that meet there: of a corner that juts out one of the
/// three is touched, in a corner that the disk lies in both segments are. The foot of a polygon lies against the point
/// that it belongs to in any case (`as_point`).
Kinematics<2> element_kinematics(const Sample& sample, const DiskRecord& disk, std::int32_t element, bool as_point);

inline Kinematics<2> kinematics_at_element(const Sample& s, std::size_t slot) {
  return element_kinematics(s, touching_disk(s, slot), element_of(s.list.j[slot]), slot >= s.list.polygons);
}

/// The place of a boundary that is touched in a slot that is met so, where the boundary itself is and not an image, m.
Vec2 touched_place(const Sample& sample, std::size_t slot, const Kinematics<2>& kinematics);

/// Whether the disk of a slot has gone through its segment since the list was built.
bool has_crossed(const Sample& sample, std::size_t slot);

}  // namespace arenite::dem
