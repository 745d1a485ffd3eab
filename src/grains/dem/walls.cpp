#include "grains/dem/walls.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grains/dem/movers.hpp"

namespace arenite::dem {
namespace {

/// A wall moves at a given speed: the others have to follow, not to come to rest.
bool is_steady(const Sample& s) {
  return std::ranges::any_of(s.wall, [](const WallBody& body) { return body.drive.kind == WallDrive::Kind::velocity; });
}

double servo_damping(const Sample& s, std::size_t side) {
  const WallBody& body = s.wall[side];
  const double carried = std::max(s.domain.wall[side].force, 0.0);
  const double share = carried >= body.drive.value ? 1.0 : carried / body.drive.value;
  const double length = s.domain.extent(axis_of(static_cast<int>(side)));
  const double yielding = std::sqrt(std::max(body.drive.value, 0.0) * body.sample_mass / length) / s.inertial_number;
  return std::min(body.impedance, yielding) * share;
}

}  // namespace

void tune_servo(Sample& s) {
  double mass = 0, stiffness = 0;
  each_mover(s, [&](std::size_t k) { mass += mover_at(s, k).mass; });
  for (std::size_t k = 0; k < s.count; ++k) stiffness += s.coefficients.pair_stiffness(s.record[k], s.record[k]) / static_cast<double>(s.count);
  const double layers = std::sqrt(static_cast<double>(std::max<std::size_t>(grain_count(s), 1)));
  const double aspect = s.domain.width() / s.domain.height();
  for (int side = 0; side < sides; ++side) {
    s.wall[side].mass = mass * std::max(0.05, std::min(1.0, 2.0 / layers));
    s.wall[side].sample_mass = mass;
    s.wall[side].impedance = std::sqrt(mass * stiffness * (axis_of(side) == 0 ? 1.0 / aspect : aspect));
  }
}

double critical_drag(const Sample& s) {
  const WallBody& slower = s.wall[left].impedance < s.wall[bottom].impedance ? s.wall[left] : s.wall[bottom];
  return std::numbers::pi * slower.impedance / slower.sample_mass;
}

void apply_drives(Sample& s, const WallDrives& drives) {
  for (int side = 0; side < sides; ++side) s.wall[side].drive = drives[side];
  const bool steady = is_steady(s);
  for (int side = 0; side < sides; ++side) {
    WallBody& body = s.wall[side];
    if (!steady) body.drift = 0;
    if (drives[side].kind == WallDrive::Kind::force) continue;
    body.rate = drives[side].kind == WallDrive::Kind::velocity ? drives[side].value : 0.0;
    body.acceleration = 0;
    body.drift = 0;
    body.higher = {};
    s.domain.wall[side].velocity = body.rate;
  }
}

double servo_braking(const Sample& s, std::size_t side, double velocity) {
  if (s.wall[side].drive.kind != WallDrive::Kind::force) return 0;
  return -servo_damping(s, side) * (velocity - s.wall[side].drift);
}

void follow_drift(Sample& s) {
  if (!is_steady(s)) return;
  for (int side = 0; side < sides; ++side) {
    WallBody& body = s.wall[side];
    if (body.drive.kind != WallDrive::Kind::force) continue;
    const double passages = 10.0 * body.sample_mass / body.impedance;
    body.drift += s.dt / passages * (s.domain.wall[side].velocity - body.drift);
  }
}

double wall_acceleration(const Sample& s, std::size_t side, double velocity) {
  const WallBody& body = s.wall[side];
  if (body.drive.kind != WallDrive::Kind::force) return 0;
  const double push = body.drive.value - s.domain.wall[side].force;
  return (inward_sign(side) * push + servo_braking(s, side, velocity)) / body.mass;
}

}  // namespace arenite::dem
