#include <algorithm>
#include <cmath>
#include <numbers>

#include "grains/dem/bodies/bodies.hpp"
#include "model/shapes.hpp"

namespace arenite::dem {
namespace {

bool is_disk(const Shapes& shapes, std::size_t g) {
  const std::int32_t d = shapes.first[g];
  return shapes.first[g + 1] - d == 1 && shapes.place[d] == Vec2{};
}

/// Corners of a filled shape turn counter-clockwise and have one radius.
bool is_convex(const Shape& shape) {
  const std::size_t n = shape.place.size();
  bool sound = n >= 3;
  for (std::size_t k = 0; k < n && sound; ++k) {
    const Vec2 here = shape.place[k], next = shape.place[(k + 1) % n], after = shape.place[(k + 2) % n];
    sound = cross(next - here, after - next) > 0 && shape.radius[k] == shape.radius[0];
  }
  return sound;
}

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

void check_shapes(Problems& problems, const Packing& start, const ContactParameters& contact,
                  const IntegrationParameters& integration) {
  const Shapes& shapes = start.grains.shapes;
  if (shapes.empty()) return;
  const std::size_t grains = start.grains.size(), disks = shapes.place.size();
  bool sound = shapes.first.size() == grains + 1 && shapes.filled.size() == grains &&
               shapes.gyration.size() == grains && shapes.radius.size() == disks && shapes.first.front() == 0 &&
               shapes.first.back() == static_cast<std::int32_t>(disks);
  for (std::size_t g = 0; g < grains && sound; ++g)
    sound = shapes.first[g + 1] > shapes.first[g] && shapes.gyration[g] > 0;
  for (std::size_t d = 0; d < disks && sound; ++d)
    sound =
        std::isfinite(shapes.place[d].x + shapes.place[d].y) && std::isfinite(shapes.radius[d]) && shapes.radius[d] > 0;
  problems.unless(
      sound,
      "the shapes of the grains must give every grain its disks, with radii above 0, and a radius of gyration above 0");
  bool filled = false;
  for (std::size_t g = 0; g < grains && sound; ++g)
    if (shapes.filled[g]) {
      filled = true;
      problems.unless(is_convex(shape_of(start.grains, g)),
                      "grain {} must be a convex polygon, corners counter-clockwise, with one rounding",
                      start.grains.id[g]);
    }
  problems.unless(
      !filled || !contact.adheres(),
      "adhesion of polygons is not implemented; leave contact.adhesion at \"none\", or use clumps of disks");
  problems.unless(!contact.has_bonds(), "bonds join disks only; leave contact.bonds at \"none\"");
  problems.unless(!contact.is_cohesive(),
                  "cohesion is not implemented for grains other than disks; leave contact.cohesion at \"none\"");
  const Integrator& scheme = integrator_of(integration.integrator);
  problems.unless(scheme.moves_bodies, "grains other than disks need integration.integrator = {}; {} moves disks only",
                  integrators_of_bodies(), scheme.word.word);
}

Packing disks_of(const Packing& from) {
  const Shapes& shapes = from.grains.shapes;
  if (shapes.empty()) return from;
  Packing packing;
  packing.materials = from.materials;
  packing.domain = from.domain;
  packing.contacts = from.contacts;
  const Grains& g = from.grains;
  Grains& disks = packing.grains;
  disks.resize(shapes.place.size());
  for (std::size_t k = 0; k < g.size(); ++k) {
    const Vec2 by = direction(g.angle[k]);
    for (std::int32_t d = shapes.first[k]; d < shapes.first[k + 1]; ++d) {
      const Vec2 arm = turned(shapes.place[d], by);
      disks.id[d] = g.id[k];
      disks.radius[d] = shapes.radius[d];
      disks.material[d] = g.material[k];
      disks.zone[d] = g.zone[k];
      put_grain(disks, d, g.position[k] + arm, g.angle[k],
                {g.velocity[k] + g.omega[k] * perpendicular(arm), g.omega[k]});
    }
  }
  return packing;
}

void make_bodies(Sample& s, const Grains& given) {
  const Shapes& shapes = given.shapes;
  if (shapes.empty()) return;
  s.given = given;
  s.part.resize(shapes.place.size());
  const CellMotion<2> cell = cell_motion(s.domain);
  for (std::size_t g = 0; g < given.size(); ++g) {
    const bool single = is_disk(shapes, g);
    const auto body = single ? -1 : static_cast<std::int32_t>(s.body.size());
    for (std::int32_t d = shapes.first[g]; d < shapes.first[g + 1]; ++d)
      s.part[d] = {static_cast<std::int32_t>(g), body, shapes.place[d], {}};
    if (single) continue;
    Body& b = s.body.emplace_back();
    b.first = shapes.first[g];
    b.count = shapes.first[g + 1] - shapes.first[g];
    b.filled = shapes.filled[g];
    b.gyration = shapes.gyration[g];
    b.mass = own_mass(s, b.first);
    b.place = given.position[g];
    b.angle = given.angle[g];
    b.seen = {given.velocity[g], s.integration.rotations ? given.omega[g] : 0.0};
    b.own = {b.seen.velocity - cell.at(b.place), b.seen.omega};
  }
  s.part_disk.resize(s.part.size());
  for (std::size_t d = 0; d < s.part.size(); ++d) s.part_disk[d] = static_cast<std::int32_t>(d);
  s.lever.assign(s.part.size(), Vec2{});
}

double cell_for_bodies(const Sample& s) {
  double reach = 0;
  for (std::size_t d = 0; d < s.part.size(); ++d)
    reach = std::max(reach, norm(s.part[d].place) + s.start.grains.radius[d]);
  return 4 * reach + 2 * s.skin;
}

double own_mass(const Sample& s, std::int32_t disk) {
  const bool single = body_of(s, disk) < 0;
  const Grains& g = single ? s.start.grains : s.given;
  const std::int32_t grain = single ? disk : grain_of(s, disk);
  const double r = g.radius[grain];
  return s.start.materials[g.material[grain]].density * std::numbers::pi * r * r * s.domain.thickness;
}

void take_masses(Sample& s) {
  for (Body& b : s.body) b.mass = s.record[s.part_disk[b.first]].mass;
}

bool has_single_disks(const Sample& s) {
  std::size_t parts = 0;
  for (const Body& b : s.body) parts += static_cast<std::size_t>(b.count);
  return parts < s.count;
}

bool is_of_slot(const Sample& s, const Contacts& c, std::size_t q, std::size_t slot) {
  if (s.part.empty() || c.off_i.empty()) return true;
  auto [i, j] = levers_of(s, slot);
  if (s.list.j[slot] >= 0 && grain_of(s, s.record[s.list.i[slot]].grain) != c.i[q]) std::swap(i, j);
  const double near = 1e-6 * s.given.radius[c.i[q]];
  return norm(i - c.off_i[q]) <= near && norm(j - c.off_j[q]) <= near;
}

Crowd crowd_around(const Sample& s, const Body& b) {
  constexpr int directions = 6;
  Crowd crowd;
  for (std::int32_t k = 0; k < b.count; ++k) {
    const std::int32_t d = b.first + k, next = b.first + (k + 1) % b.count;
    const Vec2 here = s.part[d].place, there = s.part[next].place;
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
  for (std::int32_t d = b.first; d < b.first + b.count; ++d) lever = std::max(lever, norm(s.part[d].place));
  return s.integration.rotations ? 1 / (1 / b.mass + lever * lever / b.inertia()) : b.mass;
}

}  // namespace arenite::dem
