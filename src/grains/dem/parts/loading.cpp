#include "grains/dem/parts/loading.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/membranes/membranes.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

using What = Programme::What;

/// The velocity of the step that begins after this time.
void drive_boundary(Sample& s, const Programme& p, double middle) {
  if (p.of.is_of_force()) return;
  Boundary& boundary = s.domain.boundaries[index_of(s.domain.boundaries, p.name)];
  const double rate =
      p.of.is_of_place() ? (p.at(middle + 0.5 * s.dt) - p.at(middle - 0.5 * s.dt)) / s.dt : p.at(middle);
  double* const velocity[] = {&boundary.velocity.x, &boundary.velocity.y, &boundary.spin};
  *velocity[p.of.axis()] = rate;
}

/// N, of a side under force or pressure.
double load_of(const Sample& s, const Programme& p, double time) {
  const double value = p.at(time);
  if (p.of.is(What::force)) return value;
  return value * s.domain.length(p.of.side) * s.domain.thickness;
}

bool drives_skin(const Sample& s, const Programme& p) { return p.of.is(What::pressure) && s.wall[p.of.side].skin; }

}  // namespace

void Loading::set_up(Sample& s) { tune_servo(s); }

void Loading::prepare(Sample& s) { follow_driving(s); }

void Loading::before_step(Sample& s) {
  const double time = time_of(s) + 0.5 * s.dt - programmes.begin;
  for (const Programme& p : programmes.list) {
    if (p.of.is_of_boundary()) drive_boundary(s, p, time);
    if (p.of.is(What::shear_rate)) change_shear_rate(s, p.at(time));
    if (p.of.is(What::slide)) s.wall[p.of.side].drive.slide = p.at(time);
    if (!p.of.is(What::velocity)) continue;
    s.wall[p.of.side].drive.value = s.wall[p.of.side].rate = s.domain.wall[p.of.side].velocity =
        p.at(time) * inward_sign(p.of.side);
  }
}

void Loading::after_step(Sample& s) {
  const double time = time_of(s) - programmes.begin;
  double g = programmes.gravity_size, turned = programmes.gravity_angle;
  bool weight_changes = false;
  for (const Programme& p : programmes.list) {
    if (drives_skin(s, p)) press_membrane(s, p.of.side, p.at(time));
    else if (p.of.is_of_side() && !p.of.is(What::velocity)) s.wall[p.of.side].drive.value = load_of(s, p, time);
    if (p.of.is_of_force())
      the<Boundaries>(s).body[index_of(s.domain.boundaries, p.name)].force[p.of.axis()] = p.at(time);
    if (p.of.is(What::gravity_size)) g = p.at(time);
    if (p.of.is(What::gravity_angle)) turned = p.at(time);
    weight_changes |= p.of.is(What::gravity_size) || p.of.is(What::gravity_angle);
  }
  if (weight_changes) s.gravity = g * Vec2{std::sin(turned), -std::cos(turned)};
}

WallDrives under_programmes(const Sample& s, WallDrives drives) {
  for (const Programme& p : the<Loading>(s).programmes.list) {
    if (p.of.is(What::slide)) drives[p.of.side].slide = s.wall[p.of.side].drive.slide;
    if (!p.of.is_of_side() || drives_skin(s, p)) continue;
    const int side = p.of.side;
    if (!p.of.is(What::velocity)) drives[side].value = load_of(s, p, time_of(s) - the<Loading>(s).programmes.begin);
    else if (s.wall[side].drive.kind == WallDrive::Kind::velocity) drives[side].value = s.wall[side].drive.value;
  }
  return drives;
}

void set_programmes(Sample& s, Programmes programmes) {
  const auto& boundaries = s.domain.boundaries;
  WallDrives drives;
  bool sheared = false;
  for (const Programme& p : programmes.list) {
    if (p.of.is_of_side() && !drives_skin(s, p)) drives[p.of.side].kind = WallDrive::Kind::velocity;
    sheared |= p.of.is(What::shear_rate);
    if (!p.of.is_of_boundary()) continue;
    const std::size_t at = index_of(boundaries, p.name);
    if (at == boundaries.size())
      throw InputError(fmt::format("a programme drives boundary \"{}\", which does not exist", p.name));
    BoundaryBody& body = the<Boundaries>(s).body[at];
    if (p.of.is_of_force() != (body.mass > 0) && p.of.axis() < 2)
      throw InputError(fmt::format("boundary \"{}\" {} a mass; a table can give {}", p.name,
                                   body.mass > 0 ? "has" : "does not have",
                                   body.mass > 0 ? "the force on it" : "its position or velocity"));
    if (!p.of.is_of_force()) continue;
    synchronise(s);
    (p.of.axis() == 0 ? body.force.x : body.force.y) = p.at(0);
  }
  check_still_cell(s, drives, sheared);
  the<Loading>(s).programmes = std::move(programmes);
}

}  // namespace arenite::dem
