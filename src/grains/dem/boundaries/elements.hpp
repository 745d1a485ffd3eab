#pragma once
#include <cstdint>
#include <vector>

#include "grains/dem/forces.hpp"

namespace arenite::dem {

/// What disks can touch of the domain's boundaries, in the order of their numbers.
std::vector<Element> elements_of(const Domain& domain);

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

/// The place of a boundary that is touched in a slot that is met so, where the boundary itself is and not an image, m.
Vec2 touched_place(const Sample& sample, std::size_t slot, const Kinematics<2>& kinematics);

/// Throws CannotGoOn for a disk that has gone through a boundary.
void check_crossings(const Sample& sample);

/// The boundary of a partner that is an element of one.
inline const Element& touched_element(const Sample& s, std::int32_t j) {
  return the<Boundaries>(s).element[element_of(j)];
}
inline std::size_t boundary_index(const Sample& s, std::int32_t j) {
  return static_cast<std::size_t>(touched_element(s, j).boundary);
}
inline const Boundary& boundary_of(const Sample& s, std::int32_t j) {
  return s.domain.boundaries[boundary_index(s, j)];
}

}  // namespace arenite::dem
