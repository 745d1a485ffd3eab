#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.hpp"

namespace arenite::geometry {

/// A flat convex face in space: its corners, in either sense.
using Face = std::span<const Vec3>;

/// Faces whose corners stand one face after the other, so many of each; those for which there are points.
std::vector<Face> faces_of(std::span<const Vec3> points, std::span<const std::int32_t> corners);

/// Between which points faces end or bend, each once: their edges but those between two faces in one plane.
std::vector<std::array<Vec3, 2>> edges_of(std::span<const Face> faces);

/// Closed lines along which faces that belong together end: around them all, and around each opening in them.
std::vector<std::vector<Vec3>> ends_of(std::span<const Face> faces);

/// Twice its area along the normal that its corners turn about, m^2.
Vec3 area_vector(Face face);

/// The point of a face that is nearest to a place.
Vec3 nearest_on_face(Face face, Vec3 place);

/// Whether three corners or more lie in a plane and turn one way, but for a 1e-6 of its size.
bool is_flat_and_convex(Face face);

}  // namespace arenite::geometry
