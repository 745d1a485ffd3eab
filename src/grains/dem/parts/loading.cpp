#include "grains/dem/parts/loading.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

/// The velocity of the step that begins after this time.
void drive_boundary(Sample& s, const Programme& p, double middle) {
  if (p.is_of_force()) return;
  Boundary& boundary = s.domain.boundaries[index_of(s.domain.boundaries, p.name)];
  const double rate = p.is_of_place() ? (p.at(middle + 0.5 * s.dt) - p.at(middle - 0.5 * s.dt)) / s.dt : p.at(middle);
  double* const velocity[] = {&boundary.velocity.x, &boundary.velocity.y, &boundary.spin};
  *velocity[p.boundary_axis()] = rate;
}

/// N, of a side under force or pressure.
double load_of(const Sample& s, const Programme& p, double time) {
  const double value = p.at(time);
  if (p.drive() == 1) return value;
  return value * s.domain.length(p.side()) * s.domain.thickness;
}

}  // namespace

void Loading::set_up(Sample& s) { tune_servo(s); }

void Loading::prepare(Sample& s) { follow_driving(s); }

void Loading::before_step(Sample& s) {
  const double time = time_of(s) + 0.5 * s.dt - programmes.begin;
  for (const Programme& p : programmes.list) {
    if (p.drives_boundary()) drive_boundary(s, p, time);
    if (p.of == Programme::shear_rate) change_shear_rate(s, p.at(time));
    if (p.slides_side()) s.wall[p.of - Programme::slide].drive.slide = p.at(time);
    if (!p.drives_side() || p.drive() != 0) continue;
    s.wall[p.side()].drive.value = s.wall[p.side()].rate = s.domain.wall[p.side()].velocity =
        p.at(time) * inward_sign(p.side());
  }
}

void Loading::after_step(Sample& s) {
  const double time = time_of(s) - programmes.begin;
  double g = programmes.gravity_size, turned = programmes.gravity_angle;
  bool weight_changes = false;
  for (const Programme& p : programmes.list) {
    if (p.drives_side() && p.drive() != 0) s.wall[p.side()].drive.value = load_of(s, p, time);
    if (p.is_of_force())
      the<Boundaries>(s).body[index_of(s.domain.boundaries, p.name)].force[p.boundary_axis()] = p.at(time);
    if (p.of == Programme::gravity_size) g = p.at(time);
    if (p.of == Programme::gravity_angle) turned = p.at(time);
    weight_changes |= p.of == Programme::gravity_size || p.of == Programme::gravity_angle;
  }
  if (weight_changes) s.gravity = g * Vec2{std::sin(turned), -std::cos(turned)};
}

WallDrives under_programmes(const Sample& s, WallDrives drives) {
  for (const Programme& p : the<Loading>(s).programmes.list) {
    if (p.slides_side()) drives[p.of - Programme::slide].slide = s.wall[p.of - Programme::slide].drive.slide;
    if (!p.drives_side()) continue;
    const int side = p.side();
    if (p.drive() != 0) drives[side].value = load_of(s, p, time_of(s) - the<Loading>(s).programmes.begin);
    else if (s.wall[side].drive.kind == WallDrive::Kind::velocity) drives[side].value = s.wall[side].drive.value;
  }
  return drives;
}

void set_programmes(Sample& s, Programmes programmes) {
  const auto& boundaries = s.domain.boundaries;
  WallDrives drives;
  bool sheared = false;
  for (const Programme& p : programmes.list) {
    if (p.drives_side()) drives[p.side()].kind = WallDrive::Kind::velocity;
    sheared |= p.of == Programme::shear_rate;
    if (!p.drives_boundary()) continue;
    const std::size_t at = index_of(boundaries, p.name);
    if (at == boundaries.size())
      throw InputError(fmt::format("a programme drives boundary \"{}\", which does not exist", p.name));
    BoundaryBody& body = the<Boundaries>(s).body[at];
    if (p.is_of_force() != (body.mass > 0) && p.boundary_axis() < 2)
      throw InputError(fmt::format("boundary \"{}\" {} a mass; a table can give {}", p.name,
                                   body.mass > 0 ? "has" : "does not have",
                                   body.mass > 0 ? "the force on it" : "its position or velocity"));
    if (!p.is_of_force()) continue;
    synchronise(s);
    (p.boundary_axis() == 0 ? body.force.x : body.force.y) = p.at(0);
  }
  check_still_cell(s, drives, sheared);
  the<Loading>(s).programmes = std::move(programmes);
}

}  // namespace arenite::dem
