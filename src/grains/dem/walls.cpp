#include "grains/dem/walls.hpp"

#include <numbers>

#include "grains/dem/movers.hpp"

namespace arenite::dem {

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

}  // namespace arenite::dem
