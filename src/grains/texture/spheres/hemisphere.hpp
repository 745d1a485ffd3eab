#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/vec.hpp"

namespace arenite::texture::spheres {

/// Directions without a sense, as those of contacts, in cells of equal area over the upper half of the sphere: rings
/// about the upward y, each of sectors which begin at x and turn as seen from above, towards -z.
namespace hemisphere {

inline constexpr int rings = 5, cells = 3 * rings * rings;
constexpr int sectors_of(int ring) { return 3 * (2 * ring + 1); }

struct Place {
  double radius, angle;  ///< 1 on the rim; rad from x, counter-clockwise
};

/// Lambert's azimuthal projection, which keeps areas.
inline Place projected(Vec3 n) {
  const double up = n.y < 0 ? -1 : 1, angle = std::atan2(-up * n.z, up * n.x);
  return {std::sqrt(std::max(0.0, 1 - up * n.y)), angle < 0 ? angle + 2 * std::numbers::pi : angle};
}

struct Cell {
  double inner, outer, from, to;  ///< radii, 1 on the rim; rad
};

inline std::vector<Cell> every_cell() {
  std::vector<Cell> all;
  for (int ring = 0; ring < rings; ++ring) {
    const double inner = ring, turn = 2 * std::numbers::pi / sectors_of(ring);
    for (int s = 0; s < sectors_of(ring); ++s)
      all.push_back({inner / rings, (inner + 1) / rings, s * turn, (s + 1) * turn});
  }
  return all;
}

/// Number of the cell, by rings from the pole, that a unit vector points into.
inline std::size_t cell_of(Vec3 n) {
  const Place place = projected(n);
  const int ring = std::min(rings - 1, static_cast<int>(place.radius * rings)), sectors = sectors_of(ring);
  const int sector = std::min(sectors - 1, static_cast<int>(place.angle / (2 * std::numbers::pi) * sectors));
  return static_cast<std::size_t>(3 * ring * ring + sector);
}

}  // namespace hemisphere
}  // namespace arenite::texture::spheres
