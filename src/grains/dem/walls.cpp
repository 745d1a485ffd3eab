#include "grains/dem/walls.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>

#include "core/error.hpp"
#include "grains/dem/boundaries/set_boundaries.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {

namespace {

/// Of the walls of a sample that comes to rest, as a share of the sample's.
template <int D> double resting_share(const SampleIn<D>& s) {
  return std::max(0.05, std::min(1.0, 2.0 / std::sqrt(static_cast<double>(std::max<std::size_t>(grain_count(s), 1)))));
}

/// How wide a sample is for its height above a side; share of its grains that one layer has.
double flatness_over(const Domain& domain, int side) { return domain.length(side) / domain.extent(axis_of(side)); }
double flatness_over(const DomainIn<3>& domain, int side) {
  return std::sqrt(thrust_on(domain, side, 1)) / domain.extent(axis_of(side));
}
double layer_of(const Domain& domain, int side, double grains) {
  return std::sqrt(flatness_over(domain, side) / grains);
}
double layer_of(const DomainIn<3>& domain, int side, double grains) {
  return std::cbrt(std::pow(flatness_over(domain, side), 2) / grains);
}

/// Of those of one that is driven: always less.
template <int D> double driven_share(const SampleIn<D>& s, int side) {
  const double grains = static_cast<double>(std::max<std::size_t>(grain_count(s), 1));
  const double layer = layer_of(s.domain, side, grains),
               two_grains = 2.0 / grains * std::max(1.0, flatness_over(s.domain, side));
  return std::min(s.domain.is_periodic(side) ? two_grains : layer, 0.5 * resting_share(s));
}

/// Stiffness of a crystal of grains between a side and the one across over that of one contact: contacts side by side
/// over those in a row.
template <int D> double crystal_stiffness(const SampleIn<D>& s, int side);
template <> double crystal_stiffness(const Sample& s, int side) {
  const double aspect = s.domain.width() / s.domain.height();
  return axis_of(side) == 0 ? 1.0 / aspect : aspect;
}
template <> double crystal_stiffness(const SampleIn<3>& s, int side) {
  return thrust_on(s.domain, side, 1) / (s.domain.extent(axis_of(side)) * grains_of(s).mean_diameter());
}

template <int D> void give_servo_masses(SampleIn<D>& s) {
  const bool driven = is_driven(s);
  for (int side = 0; side < sides_in<D>; ++side) {
    WallBodyIn<D>& body = s.wall[side];
    body.mass = body.sample_mass * (driven ? driven_share(s, side) : resting_share(s));
    if (!driven) body.drift = 0;
  }
}

template <int D> void check_opening(const SampleIn<D>& s, int side, bool open) {
  if (open && s.domain.is_periodic(side))
    throw InputError(fmt::format("the {} side is periodic and has no wall that could be open", any_side_names[side]));
  std::size_t beyond = 0;
  for (std::size_t k = 0; k < s.count; ++k) beyond += s.domain.depth(side, s.record[k].place) < 0;
  if (!open && beyond > 0)
    throw InputError(
        fmt::format("the {} wall cannot be restored, because {} grains are beyond it; leave that side open",
                    any_side_names[side], beyond));
}

/// A wall that becomes fixed or velocity-driven takes its velocity at once, one that becomes force-controlled goes on
/// from the velocity that it has.
template <int D> void apply_drives(SampleIn<D>& s, const WallDrivesIn<D>& drives) {
  for (int side = 0; side < sides_in<D>; ++side) s.wall[side].drive = drives[side];
  for (int side = 0; side < sides_in<D>; ++side) {
    WallBodyIn<D>& body = s.wall[side];
    if (drives[side].kind == DriveKind::force) continue;
    body.rate = drives[side].kind == DriveKind::velocity ? drives[side].value : 0.0;
    body.acceleration = 0;
    body.drift = 0;
    body.higher = {};
    s.domain.wall[side].velocity = body.rate;
  }
}

}  // namespace

template <int D> void tune_servo(SampleIn<D>& s) {
  double mass = 0, stiffness = 0;
  each_mover(s, [&](std::size_t k) { mass += mover_at(s, k).mass; });
  for (std::size_t k = 0; k < s.count; ++k)
    stiffness += s.coefficients.pair_stiffness(s.record[k], s.record[k]) / static_cast<double>(s.count);
  for (int side = 0; side < sides_in<D>; ++side) {
    s.wall[side].sample_mass = mass;
    s.wall[side].impedance = std::sqrt(mass * stiffness * crystal_stiffness(s, side));
  }
  give_servo_masses(s);
}

template <int D> double servo_energy(const SampleIn<D>& s) {
  double sum = 0;
  for (const WallBodyIn<D>& body : s.wall)
    if (body.drive.kind == DriveKind::force) sum += 0.5 * body.mass * body.rate * body.rate;
  return sum;
}

template <int D> void follow_driving(SampleIn<D>& s) {
  const auto pressed = [](const WallBodyIn<D>& body) { return body.drive.kind == DriveKind::force; };
  const bool was_driven = s.wall[left].mass < s.wall[left].sample_mass * resting_share(s);
  if (was_driven == is_driven(s) || std::ranges::none_of(s.wall, pressed)) return;
  synchronise(s);
  book_change(s, &Energies::dissipated_drag, servo_energy<D>, [&] { give_servo_masses(s); });
}

template <int D> double critical_drag(const SampleIn<D>& s) {
  const WallBodyIn<D>& slower = *std::ranges::min_element(s.wall, {}, &WallBodyIn<D>::impedance);
  return std::numbers::pi * slower.impedance / slower.sample_mass;
}

template <int D> void set_drives(SampleIn<D>& s, const WallDrivesIn<D>& asked) {
  const WallDrivesIn<D> drives = under_programmes(s, asked);
  if (std::ranges::equal(drives, s.wall, {}, {}, &WallBodyIn<D>::drive)) return;
  check_still_cell(s, drives, false);
  synchronise(s);
  book_change(s, &Energies::dissipated_drag, servo_energy<D>, [&] { apply_drives(s, drives); });
}

template <int D> void set_inertial_number(SampleIn<D>& s, double number) {
  if (!(number > 0)) throw InputError(fmt::format("inertial number {} must be above 0", number));
  s.inertial_number = number;
}

template <int D> void set_open(SampleIn<D>& s, const ByAnySide<bool>& open, const ThreadPool& pool) {
  bool changes = false;
  for (int side = 0; side < sides_in<D>; ++side) {
    if (open[side] == s.wall[side].open) continue;
    check_opening(s, side, open[side]);
    changes = true;
  }
  if (!changes) return;
  synchronise(s);
  for (int side = 0; side < sides_in<D>; ++side) {
    s.wall[side].open = open[side];
    if (open[side]) s.domain.wall[side].force = 0, s.domain.wall[side].shear_force = {};
  }
  apply_open(s);
  list_anew(s, pool);
}

template void tune_servo(Sample&);
template void tune_servo(SampleIn<3>&);
template double servo_energy(const Sample&);
template double servo_energy(const SampleIn<3>&);
template void follow_driving(Sample&);
template void follow_driving(SampleIn<3>&);
template double critical_drag(const Sample&);
template double critical_drag(const SampleIn<3>&);
template void set_drives(Sample&, const WallDrives&);
template void set_drives(SampleIn<3>&, const WallDrivesIn<3>&);
template void set_inertial_number(Sample&, double);
template void set_inertial_number(SampleIn<3>&, double);
template void set_open(Sample&, const ByAnySide<bool>&, const ThreadPool&);
template void set_open(SampleIn<3>&, const ByAnySide<bool>&, const ThreadPool&);

}  // namespace arenite::dem
