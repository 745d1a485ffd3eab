#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "geometry/meniscus.hpp"

namespace arenite {

/// Spheres in space, from anybody's table.
struct SpherePack {
  std::vector<Vec3> centre;         ///< m
  std::vector<double> radius;       ///< m
  std::vector<std::int32_t> label;  ///< of each: its place in the table, which images share
  Vec3 low, high;                   ///< corners of the box that is cut out, m
  bool periodic = false;            ///< the spheres repeat themselves beyond the box
  std::size_t size() const { return radius.size(); }
};

/// Neck between two spheres: a truncated cone about the line of their centres, m.
struct SphereNeck {
  Vec3 a, b;              ///< centres, of images too
  double half_a, half_b;  ///< its radius at each
};

/// A meniscus between two spheres, turned about the line of their centres.
struct SphereMeniscus {
  Vec3 a, b;                      ///< centres, of images too, m
  geometry::MeniscusShape shape;  ///< its half section, from `a`
};

/// Matrix between spheres.
struct SphereCement {
  bool full = false;   ///< all space between the spheres
  double coating = 0;  ///< thickness of a layer on each, m
  std::vector<SphereNeck> necks;
  std::vector<SphereMeniscus> menisci;
};

}  // namespace arenite
