#include "grains/dem/walls.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>

#include "core/error.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {

namespace {

/// Of the walls of a sample that comes to rest, as a share of the sample's.
double resting_share(const Sample& s) {
  return std::max(0.05, std::min(1.0, 2.0 / std::sqrt(static_cast<double>(std::max<std::size_t>(grain_count(s), 1)))));
}

/// Of those of one that is driven: always less.
double driven_share(const Sample& s, int side) {
  const double grains = static_cast<double>(std::max<std::size_t>(grain_count(s), 1));
  const double flatness = s.domain.length(side) / s.domain.extent(axis_of(side));
  const double layer = std::sqrt(flatness / grains), two_grains = 2.0 / grains * std::max(1.0, flatness);
  return std::min(s.domain.is_periodic(side) ? two_grains : layer, 0.5 * resting_share(s));
}

void give_servo_masses(Sample& s) {
  const bool driven = is_driven(s);
  for (int side = 0; side < sides; ++side) {
    WallBody& body = s.wall[side];
    body.mass = body.sample_mass * (driven ? driven_share(s, side) : resting_share(s));
    if (!driven) body.drift = 0;
  }
}

void check_opening(const Sample& s, int side, bool open) {
  if (open && s.domain.is_periodic(side))
    throw InputError(fmt::format("the {} side is periodic and has no wall that could be open", side_names[side]));
  std::size_t beyond = 0;
  for (std::size_t k = 0; k < s.count; ++k) beyond += s.domain.depth(side, s.record[k].place) < 0;
  if (!open && beyond > 0)
    throw InputError(
        fmt::format("the {} wall cannot be restored, because {} grains are beyond it; leave that side open",
                    side_names[side], beyond));
}

/// A wall that becomes fixed or velocity-driven takes its velocity at once, one that becomes force-controlled goes on
/// from the velocity that it has.
void apply_drives(Sample& s, const WallDrives& drives) {
  for (int side = 0; side < sides; ++side) s.wall[side].drive = drives[side];
  for (int side = 0; side < sides; ++side) {
    WallBody& body = s.wall[side];
    if (drives[side].kind == WallDrive::Kind::force) continue;
    body.rate = drives[side].kind == WallDrive::Kind::velocity ? drives[side].value : 0.0;
    body.acceleration = 0;
    body.drift = 0;
    body.higher = {};
    s.domain.wall[side].velocity = body.rate;
  }
}

}  // namespace

void tune_servo(Sample& s) {
  double mass = 0, stiffness = 0;
  each_mover(s, [&](std::size_t k) { mass += mover_at(s, k).mass; });
  for (std::size_t k = 0; k < s.count; ++k)
    stiffness += s.coefficients.pair_stiffness(s.record[k], s.record[k]) / static_cast<double>(s.count);
  const double aspect = s.domain.width() / s.domain.height();
  for (int side = 0; side < sides; ++side) {
    s.wall[side].sample_mass = mass;
    s.wall[side].impedance = std::sqrt(mass * stiffness * (axis_of(side) == 0 ? 1.0 / aspect : aspect));
  }
  give_servo_masses(s);
}

double servo_energy(const Sample& s) {
  double sum = 0;
  for (const WallBody& body : s.wall)
    if (body.drive.kind == WallDrive::Kind::force) sum += 0.5 * body.mass * body.rate * body.rate;
  return sum;
}

void follow_driving(Sample& s) {
  const auto pressed = [](const WallBody& body) { return body.drive.kind == WallDrive::Kind::force; };
  const bool was_driven = s.wall[left].mass < s.wall[left].sample_mass * resting_share(s);
  if (was_driven == is_driven(s) || std::ranges::none_of(s.wall, pressed)) return;
  synchronise(s);
  book_change(s, &Energies::dissipated_drag, servo_energy, [&] { give_servo_masses(s); });
}

double critical_drag(const Sample& s) {
  const WallBody& slower = s.wall[left].impedance < s.wall[bottom].impedance ? s.wall[left] : s.wall[bottom];
  return std::numbers::pi * slower.impedance / slower.sample_mass;
}

void set_drives(Sample& s, const WallDrives& asked) {
  const WallDrives drives = under_programmes(s, asked);
  if (std::ranges::equal(drives, s.wall, {}, {}, &WallBody::drive)) return;
  check_still_cell(s, drives, false);
  synchronise(s);
  book_change(s, &Energies::dissipated_drag, servo_energy, [&] { apply_drives(s, drives); });
}

void set_inertial_number(Sample& s, double number) {
  if (!(number > 0)) throw InputError(fmt::format("inertial number {} must be above 0", number));
  s.inertial_number = number;
}

void set_open(Sample& s, const BySide<bool>& open, const ThreadPool& pool) {
  if (std::ranges::equal(open, s.wall, {}, {}, &WallBody::open)) return;
  for (int side = 0; side < sides; ++side)
    if (open[side] != s.wall[side].open) check_opening(s, side, open[side]);
  synchronise(s);
  for (int side = 0; side < sides; ++side) {
    s.wall[side].open = open[side];
    if (open[side]) s.domain.wall[side].force = s.domain.wall[side].shear_force = 0;
  }
  apply_open(s);
  list_anew(s, pool);
}

void apply_open(Sample& s) {
  for (int side = 0; side < sides; ++side)
    s.domain.wall[side].present = s.listed_domain.wall[side].present =
        s.start.domain.wall[side].present && !s.domain.is_periodic(side) && !s.wall[side].open;
}

}  // namespace arenite::dem
