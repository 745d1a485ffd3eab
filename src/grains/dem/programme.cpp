#include "grains/dem/programme.hpp"

#include <algorithm>
#include <cmath>

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/setup.hpp"

namespace arenite::dem {

double Programme::at(double time) const {
  if (const double period = table.back().x; repeat && period > 0) time -= period * std::floor(time / period);
  const auto after =
      std::upper_bound(table.begin(), table.end(), time, [](double t, const Vec2& row) { return t < row.x; });
  if (after == table.begin()) return table.front().y;
  if (after == table.end()) return table.back().y;
  const Vec2 &a = *(after - 1), &b = *after;
  return a.y + (time - a.x) / (b.x - a.x) * (b.y - a.y);
}

double integral(const Programme& p, double time) {
  const double period = p.table.back().x;
  if (p.repeat && period > 0 && time >= period) {
    Programme once = p;
    once.repeat = false;
    const double whole = std::floor(time / period);
    return whole * integral(once, period) + integral(once, time - whole * period);
  }
  double sum = 0, from = 0;
  for (const Vec2& row : p.table) {
    const double to = std::min(time, row.x);
    if (to > from) sum += 0.5 * (p.at(from) + (row.x > time ? p.at(time) : row.y)) * (to - from), from = to;
  }
  return sum + std::max(0.0, time - from) * p.table.back().y;
}

Vec2 gravity_at(const Stage& stage, double time) {
  if (!stage.gravity) return {};
  double g = stage.gravity_size, turned = stage.gravity_angle;
  for (const Programme& p : stage.programmes) {
    if (p.of == Programme::gravity_size) g = p.at(time);
    if (p.of == Programme::gravity_angle) turned = p.at(time);
  }
  return g * Vec2{std::sin(turned), -std::cos(turned)};
}

void change_shear_rate(Sample& s, double rate) {
  if (rate == s.shear_rate) return;
  const double middle = 0.5 * (s.domain.wall[bottom].position + s.domain.wall[top].position);
  const auto faster_at = [&](double y) { return (rate - s.shear_rate) * (y - middle); };
  book_change(s, &Energies::work_walls, &Energies::kinetic, [&] {
    for (std::size_t k = 0; k < s.count; ++k) {
      s.velocity.along[0][k] += faster_at(s.record[k].place.y);
      s.record[k].velocity.x += faster_at(s.record[k].place.y);
    }
    for (Body& b : s.body) {
      b.own.velocity.x += faster_at(b.place.y);
      b.seen.velocity.x += faster_at(b.place.y);
    }
    s.shear_rate = rate;
    place_parts(s);
  });
}

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

void follow_velocities(Sample& s) {
  const double time = time_of(s) + 0.5 * s.dt - s.programmes.begin;
  for (const Programme& p : s.programmes.list) {
    if (p.drives_boundary()) drive_boundary(s, p, time);
    if (p.of == Programme::shear_rate) change_shear_rate(s, p.at(time));
    if (p.slides_side()) s.wall[p.of - Programme::slide].drive.slide = p.at(time);
    if (!p.drives_side() || p.drive() != 0) continue;
    s.wall[p.side()].drive.value = s.wall[p.side()].rate = s.domain.wall[p.side()].velocity =
        p.at(time) * inward_sign(p.side());
  }
}

void follow_loads(Sample& s) {
  const double time = time_of(s) - s.programmes.begin;
  double g = s.programmes.gravity_size, turned = s.programmes.gravity_angle;
  bool weight_changes = false;
  for (const Programme& p : s.programmes.list) {
    if (p.drives_side() && p.drive() != 0) s.wall[p.side()].drive.value = load_of(s, p, time);
    if (p.is_of_force()) s.boundary[index_of(s.domain.boundaries, p.name)].force[p.boundary_axis()] = p.at(time);
    if (p.of == Programme::gravity_size) g = p.at(time);
    if (p.of == Programme::gravity_angle) turned = p.at(time);
    weight_changes |= p.of == Programme::gravity_size || p.of == Programme::gravity_angle;
  }
  if (weight_changes) s.gravity = g * Vec2{std::sin(turned), -std::cos(turned)};
}

WallDrives under_programmes(const Sample& s, WallDrives drives) {
  for (const Programme& p : s.programmes.list) {
    if (p.slides_side()) drives[p.of - Programme::slide].slide = s.wall[p.of - Programme::slide].drive.slide;
    if (!p.drives_side()) continue;
    const int side = p.side();
    if (p.drive() != 0) drives[side].value = load_of(s, p, time_of(s) - s.programmes.begin);
    else if (s.wall[side].drive.kind == WallDrive::Kind::velocity) drives[side].value = s.wall[side].drive.value;
  }
  return drives;
}

}  // namespace arenite::dem
