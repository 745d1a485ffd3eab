#pragma once
#include <vector>

#include "core/problems.hpp"
#include "geometry/rectangle.hpp"
#include "grains/dem/forces.hpp"

// Boundaries of straight segments that move as they are told. A contact with one is a slot like a wall's, joined with
// an element: a point or a segment.
namespace arenite::dem {

/// What disks can touch of the domain's boundaries, in the order of their numbers.
std::vector<Element> elements_of(const Domain& domain);

/// Finds boundaries that make no sense: too few points, points that coincide, segments longer than a periodic cell.
void check_boundaries(Problems& problems, const Domain& domain);

/// Whether an open boundary ends at an image of the point that it begins at, and so has no ends.
bool goes_through_sides(const Domain& domain, const Boundary& boundary);

/// Whether a point of a boundary juts out towards a place near it, as seen from there: an end, or an angle above 180
/// degrees. Where the place lies in a corner, or the boundary goes straight on, sides of polygons cannot touch the
/// point.
bool juts_out(const Domain& domain, const Boundary& boundary, std::size_t point, Vec2 place);

/// Finds the elements of present boundaries nearer to a disk's rim than the skin, in the order of their numbers; `box`
/// is around each boundary.
void find_near_elements(const Sample& sample, const std::vector<geometry::Rectangle>& box, const DiskRecord& disk,
                        std::vector<std::int32_t>& near);

/// Moves and turns the boundaries by a time, s.
void move_boundaries(Sample& sample, double time);

/// A step of Verlet of the boundaries with a mass; `kick` and `ahead` as for disks, s. The way is made by
/// move_boundaries.
void push_boundaries(Sample& sample, double kick, double ahead);

/// Force on a boundary that has a mass, its weight included, N; its velocity now, m/s, of one that has none as it is
/// told.
Vec2 force_on(const Sample& sample, std::size_t boundary);
Vec2 velocity_of(const Sample& sample, std::size_t boundary);

/// Puts boundaries whose middle has left a periodic cell back by whole cells.
void wrap_boundaries(Domain& domain);

/// The farthest way of a point of the boundaries between two states, m.
double farthest_moved(const Domain& then, const Domain& now);

/// Speed of the fastest point of the boundaries, m/s.
double fastest_point(const Domain& domain);

/// A disk that rolls from a segment over a corner goes on with the springs that it has: the contact that begins takes
/// them from its neighbour along the boundary that ends.
void hand_over_memories(Sample& sample);

/// Throws CannotGoOn, naming grain, boundary and step, if the centre of a listed disk has gone through a segment since
/// the list was built.
void check_crossings(const Sample& sample);

/// The place of a boundary that is touched in a slot that is met so, where the boundary itself is and not an image, m.
Vec2 touched_place(const Sample& sample, std::size_t slot, const Kinematics<2>& kinematics);

/// Forces of the grains on the boundaries, and their torques about the centres.
void sum_boundary_forces(Sample& sample);

/// Throws InputError for sides of a periodic cell that are driven, or sheared, where there are boundaries, which stay
/// as they are.
void check_still_cell(const Sample& sample, const WallDrives& drives, bool sheared);

/// Walls are absent where they are open, else as they were given.
void apply_open(Sample& sample);

/// The boundary of a partner that is an element of one.
inline const Element& touched_element(const Sample& s, std::int32_t j) { return s.element[element_of(j)]; }
inline std::size_t boundary_index(const Sample& s, std::int32_t j) {
  return static_cast<std::size_t>(touched_element(s, j).boundary);
}
inline const Boundary& boundary_of(const Sample& s, std::int32_t j) {
  return s.domain.boundaries[boundary_index(s, j)];
}

}  // namespace arenite::dem
