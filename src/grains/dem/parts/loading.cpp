#include "grains/dem/parts/loading.hpp"

#include <fmt/core.h>

#include <utility>

#include "core/error.hpp"
#include "grains/dem/boundaries/set_boundaries.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/membranes/membranes.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

using What = Programme::What;

/// The speed of a boundary along or about an axis (Driven::way).
double& speed_of(Boundary& boundary, int way) { return way == 3 ? boundary.spin : boundary.velocity[way]; }
double& speed_of(BoundaryIn<3>& boundary, int way) {
  return way < 3 ? boundary.velocity[way] : boundary.spin[(way - 1) % 3];
}

/// The velocity of the step that begins after this time.
template <int D> void drive_boundary(SampleIn<D>& s, const Programme& p, double middle) {
  if (p.of.is_of_force()) return;
  BoundaryIn<D>& boundary = s.domain.boundaries[index_of(s.domain.boundaries, p.name)];
  speed_of(boundary, p.of.way()) =
      p.of.is_of_place() ? (p.at(middle + 0.5 * s.dt) - p.at(middle - 0.5 * s.dt)) / s.dt : p.at(middle);
}

/// N, of a side under force or pressure.
template <int D> double load_of(const SampleIn<D>& s, const Programme& p, double time) {
  const double value = p.at(time);
  return p.of.is(What::force) ? value : thrust_on(s.domain, p.of.side, value);
}

template <int D> bool drives_skin(const SampleIn<D>& s, const Programme& p) {
  return p.of.is(What::pressure) && s.wall[p.of.side].skin;
}

void press_skin(Sample& s, int side, double pressure) { press_membrane(s, side, pressure); }
void press_skin(SampleIn<3>& /*sample*/, int /*side*/, double /*pressure*/) {}

template <int D> void force_boundary(SampleIn<D>& s, const Programme& p, double time) {
  the<BoundariesIn<D>>(s).body[index_of(s.domain.boundaries, p.name)].force[p.of.way()] = p.at(time);
}

/// Refuses a boundary that cannot be driven so, and sets the force that drives one at the beginning.
template <int D> void begin_boundary(SampleIn<D>& s, const Programme& p) {
  const std::size_t at = index_of(s.domain.boundaries, p.name);
  if (at == s.domain.boundaries.size())
    throw InputError(fmt::format("a programme drives boundary \"{}\", which does not exist", p.name));
  BoundaryBodyIn<D>& body = the<BoundariesIn<D>>(s).body[at];
  if (p.of.is_of_force() != (body.mass > 0) && !p.of.turns())
    throw InputError(fmt::format("boundary \"{}\" {} a mass; a table can give {}", p.name,
                                 body.mass > 0 ? "has" : "does not have",
                                 body.mass > 0 ? "the force on it" : "its position or velocity"));
  if (!p.of.is_of_force()) return;
  synchronise(s);
  body.force[p.of.way()] = p.at(0);
}

}  // namespace

template <int D> void LoadingIn<D>::set_up(SampleIn<D>& s) { tune_servo(s); }

template <int D> void LoadingIn<D>::prepare(SampleIn<D>& s) { follow_driving(s); }

template <int D> void LoadingIn<D>::before_step(SampleIn<D>& s) {
  const double time = time_of(s) + 0.5 * s.dt - programmes.begin;
  for (const Programme& p : programmes.list) {
    if (p.of.is_of_boundary()) drive_boundary(s, p, time);
    if (p.of.is(What::shear_rate)) change_shear_rate(s, p.at(time));
    if (p.of.is(What::slide)) s.wall[p.of.side].drive.slide = way_along<D>(p.of.side, p.at(time));
    if (!p.of.is(What::velocity)) continue;
    s.wall[p.of.side].drive.value = s.wall[p.of.side].rate = s.domain.wall[p.of.side].velocity =
        p.at(time) * inward_sign(p.of.side);
  }
}

template <int D> void LoadingIn<D>::after_step(SampleIn<D>& s) {
  const double time = time_of(s) - programmes.begin;
  double g = programmes.gravity_size, turned = programmes.gravity_angle;
  bool weight_changes = false;
  for (const Programme& p : programmes.list) {
    if (drives_skin(s, p)) press_skin(s, p.of.side, p.at(time));
    else if (p.of.is_of_side() && !p.of.is(What::velocity)) s.wall[p.of.side].drive.value = load_of(s, p, time);
    if (p.of.is_of_force()) force_boundary(s, p, time);
    if (p.of.is(What::gravity_size)) g = p.at(time);
    if (p.of.is(What::gravity_angle)) turned = p.at(time);
    weight_changes |= p.of.is(What::gravity_size) || p.of.is(What::gravity_angle);
  }
  if (weight_changes) s.gravity = gravity_along<D>(g, turned);
}

template <int D> WallDrivesIn<D> under_programmes(const SampleIn<D>& s, WallDrivesIn<D> drives) {
  for (const Programme& p : the<LoadingIn<D>>(s).programmes.list) {
    if (p.of.is(What::slide)) drives[p.of.side].slide = s.wall[p.of.side].drive.slide;
    if (!p.of.is_of_side() || drives_skin(s, p)) continue;
    const int side = p.of.side;
    if (!p.of.is(What::velocity))
      drives[side].value = load_of(s, p, time_of(s) - the<LoadingIn<D>>(s).programmes.begin);
    else if (s.wall[side].drive.kind == DriveKind::velocity) drives[side].value = s.wall[side].drive.value;
  }
  return drives;
}

template <int D> void set_programmes(SampleIn<D>& s, Programmes programmes) {
  WallDrivesIn<D> drives;
  bool sheared = false;
  for (const Programme& p : programmes.list) {
    if (p.of.is_of_side() && !drives_skin(s, p)) drives[p.of.side].kind = DriveKind::velocity;
    sheared |= p.of.is(What::shear_rate);
    if (p.of.is_of_boundary()) begin_boundary(s, p);
  }
  check_still_cell(s, drives, sheared);
  the<LoadingIn<D>>(s).programmes = std::move(programmes);
}

template struct LoadingIn<2>;
template struct LoadingIn<3>;
template WallDrives under_programmes(const Sample&, WallDrives);
template WallDrivesIn<3> under_programmes(const SampleIn<3>&, WallDrivesIn<3>);
template void set_programmes(Sample&, Programmes);
template void set_programmes(SampleIn<3>&, Programmes);

}  // namespace arenite::dem
