#include <algorithm>
#include <numbers>

#include "grains/dem/bodies/bodies.hpp"
#include "model/shapes.hpp"

namespace arenite::dem {
namespace {

double radius_of(const Sample& s, std::int32_t d) { return s.start.grains.radius[d]; }

/// Whether a point, from the body's centre at angle 0, lies within a disk of it other than `own`.
bool is_within(const Sample& s, const Body& b, std::int32_t own, Vec2 point) {
  for (std::int32_t d = b.first; d < b.first + b.count; ++d)
    if (d != own && norm(point - s.part[d].place) < (1 - 1e-9) * radius_of(s, d)) return true;
  return false;
}

void add_contact(Crowd& crowd, Vec2 centre, double radius, Vec2 n) {
  const double normal = cross(centre, n), tangential = dot(centre, n) + radius;
  crowd.contacts += 1;
  crowd.normal_levers += normal * normal;
  crowd.tangential_levers += tangential * tangential;
}

}  // namespace

std::vector<Mover> movers_of(const Sample& s) {
  std::vector<Mover> movers(s.count + s.body.size());
  for (std::size_t k = 0; k < s.count; ++k)
    if (!is_part(s, k)) movers[k] = {s.record[k].mass, inertia(s.record[k]), s.record[k].radius};
  for (std::size_t n = 0; n < s.body.size(); ++n) movers[s.count + n] = {s.body[n].mass, s.body[n].inertia(), s.body[n].gyration};
  return movers;
}

std::size_t moving(const Sample& s, std::int32_t k) {
  const std::int32_t body = body_of(s, s.record[k].grain);
  return body < 0 ? static_cast<std::size_t>(k) : s.count + static_cast<std::size_t>(body);
}

Crowd crowd_around(const Sample& s, const Body& b) {
  constexpr int directions = 6;
  Crowd crowd;
  for (std::int32_t k = 0; k < b.count; ++k) {
    const std::int32_t d = b.first + k, next = b.first + (k + 1) % b.count;
    const Vec2 here = s.part[d].place, there = s.part[next].place;
    for (int q = 0; q < directions && !b.filled; ++q)
      if (const Vec2 n = direction(2 * std::numbers::pi * (q + 0.5) / directions); !is_within(s, b, d, here + radius_of(s, d) * n))
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
  for (std::int32_t d = b.first; d < b.first + b.count; ++d) lever = std::max(lever, norm(s.part[d].place));
  return s.integration.rotations ? 1 / (1 / b.mass + lever * lever / b.inertia()) : b.mass;
}

}  // namespace arenite::dem
