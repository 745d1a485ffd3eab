#include "grains/dem/bodies/make.hpp"

#include <cmath>
#include <cstdint>

#include "core/problems.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/sample.hpp"
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
  Bodies& all = the<Bodies>(s);
  all.caller = given;
  all.part.resize(shapes.place.size());
  const CellMotion<2> cell = cell_motion(s.domain);
  for (std::size_t g = 0; g < given.size(); ++g) {
    const bool single = is_disk(shapes, g);
    const auto body = single ? -1 : static_cast<std::int32_t>(all.body.size());
    for (std::int32_t d = shapes.first[g]; d < shapes.first[g + 1]; ++d)
      all.part[d] = {static_cast<std::int32_t>(g), body, shapes.place[d], {}};
    if (single) continue;
    Body& b = all.body.emplace_back();
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
  all.disk.resize(all.part.size());
  for (std::size_t d = 0; d < all.part.size(); ++d) all.disk[d] = static_cast<std::int32_t>(d);
  all.lever.assign(all.part.size(), Vec2{});
}

}  // namespace arenite::dem
