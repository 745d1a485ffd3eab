#include "dem/walls.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::dem {

namespace {

constexpr double yielding_inertial_number = 0.01;

}  // namespace

void tune_servo(Sample& s) {
  double mass = 0, stiffness = 0;
  for (std::size_t k = 0; k < s.count; ++k) {
    const auto& d = s.record[k];
    mass += d.mass;
    stiffness += s.coefficients.pair_stiffness(d.material, d.material) / static_cast<double>(s.count);
  }
  const double layers = std::sqrt(static_cast<double>(std::max<std::size_t>(s.count, 1)));
  const double aspect = s.domain.width() / s.domain.height();
  for (std::size_t side = 0; side < 4; ++side) {
    s.wall[side].mass = mass * std::max(0.05, std::min(1.0, 2.0 / layers));
    s.wall[side].sample_mass = mass;
    s.wall[side].impedance = std::sqrt(mass * stiffness * (side < bottom ? 1.0 / aspect : aspect));
  }
}

void apply_drives(Sample& s, const WallDrives& drives) {
  for (std::size_t side = 0; side < 4; ++side) {
    WallBody& body = s.wall[side];
    body.drive = drives[side];
    if (drives[side].kind == WallDrive::Kind::force) continue;
    body.rate = drives[side].kind == WallDrive::Kind::velocity ? drives[side].value : 0.0;
    body.acceleration = 0;
    body.higher = {};
    s.domain.wall[side].velocity = body.rate;
  }
}

double servo_damping(const Sample& s, std::size_t side) {
  const WallBody& body = s.wall[side];
  if (body.drive.kind != WallDrive::Kind::force) return 0;
  const double carried = std::max(s.domain.wall[side].force, 0.0);
  const double share = carried >= body.drive.value ? 1.0 : carried / body.drive.value;
  const double length = side < bottom ? s.domain.width() : s.domain.height();
  const double yielding = std::sqrt(std::max(body.drive.value, 0.0) * body.sample_mass / length) / yielding_inertial_number;
  return std::min(body.impedance, yielding) * share;
}

double wall_acceleration(const Sample& s, std::size_t side, double velocity) {
  const WallBody& body = s.wall[side];
  if (body.drive.kind != WallDrive::Kind::force) return 0;
  const double push = body.drive.value - s.domain.wall[side].force;
  return (inward_sign(side) * push - servo_damping(s, side) * velocity) / body.mass;
}

}  // namespace arenite::dem
