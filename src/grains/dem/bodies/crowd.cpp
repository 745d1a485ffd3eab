#include "grains/dem/bodies/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "grains/dem/sample.hpp"
#include "model/shapes.hpp"

namespace arenite::dem {
namespace {

double radius_of(const Sample& s, std::int32_t d) { return s.start.grains.radius[d]; }

/// Whether a point, from the body's centre at angle 0, lies within a disk of it other than `own`.
bool is_within(const Sample& s, const Body& b, std::int32_t own, Vec2 point) {
  for (std::int32_t d = b.first; d < b.first + b.count; ++d)
    if (d != own && norm(point - the<Bodies>(s).part[d].place) < (1 - 1e-9) * radius_of(s, d)) return true;
  return false;
}

void add_contact(Crowd& crowd, Vec2 centre, double radius, Vec2 n) {
  const double normal = cross(centre, n), tangential = dot(centre, n) + radius;
  crowd.contacts += 1;
  crowd.normal_levers += normal * normal;
  crowd.tangential_levers += tangential * tangential;
}

}  // namespace

Crowd crowd_around(const Sample& s, const Body& b) {
  constexpr int directions = 6;
  Crowd crowd;
  for (std::int32_t k = 0; k < b.count; ++k) {
    const std::int32_t d = b.first + k, next = b.first + (k + 1) % b.count;
    const Vec2 here = the<Bodies>(s).part[d].place, there = the<Bodies>(s).part[next].place;
    for (int q = 0; q < directions && !b.filled; ++q)
      if (const Vec2 n = direction(2 * std::numbers::pi * (q + 0.5) / directions);
          !is_within(s, b, d, here + radius_of(s, d) * n))
        add_contact(crowd, here, radius_of(s, d), n);
    if (!b.filled) continue;
    const Vec2 n = -perpendicular(there - here) / norm(there - here);
    for (const Vec2& end : {here, there})
      for (int times = 0; times < 2; ++times) add_contact(crowd, end, radius_of(s, d), n);
  }
  return crowd;
}

double lightest_mass(const Sample& s, const Body& b) {
  double lever = 0;
  for (std::int32_t d = b.first; d < b.first + b.count; ++d)
    lever = std::max(lever, norm(the<Bodies>(s).part[d].place));
  return s.integration.rotations ? 1 / (1 / b.mass + lever * lever / b.inertia()) : b.mass;
}

}  // namespace arenite::dem
