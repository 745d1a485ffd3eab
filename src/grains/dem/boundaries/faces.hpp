#pragma once
#include <cstdint>
#include <vector>

#include "grains/dem/boundaries/elements.hpp"

namespace arenite::dem {

/// What is wrong with a boundary in space: points that belong to no face, faces that are not flat and convex or longer
/// than a periodic cell.
void check_shape(Problems& problems, const DomainIn<3>& domain, const BoundaryIn<3>& boundary);

/// The faces of all boundaries, in the order of their numbers.
std::vector<ElementIn<3>> elements_of(const DomainIn<3>& domain);

/// Whether the faces of two partners meet.
bool are_neighbours(const SampleIn<3>& sample, std::int32_t j, std::int32_t k);

/// Finds the faces of present boundaries nearer to a sphere's surface than the skin, in the order of their numbers.
void find_near_elements(const SampleIn<3>& sample, const GrainRecord<3>& sphere, std::vector<std::int32_t>& near);

/// A sphere and a face, which it touches at the face's nearest point: within it, on an edge or at a corner. A place
/// where faces of a boundary meet is touched where none of them comes nearer beside it, and then in one of them alone;
/// so a sphere rolls over the seams of a plane as over a plane, and over an edge that juts out as over one edge, while
/// in a corner it leans on all faces.
Kinematics<3> kinematics_at_element(const SampleIn<3>& sample, std::size_t slot);

/// The place of a boundary that is touched in a slot that is met so, where the boundary itself is and not an image, m.
Vec3 touched_place(const SampleIn<3>& sample, std::size_t slot, const Kinematics<3>& kinematics);

/// Whether the sphere of a slot has gone through its face since the list was built.
bool has_crossed(const SampleIn<3>& sample, std::size_t slot);

}  // namespace arenite::dem
