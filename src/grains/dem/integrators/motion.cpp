#include "grains/dem/integrators/motion.hpp"

#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {

Acceleration acceleration_under(const Sample& s, const Load& load, double mass, double inertia, Vec2 place, Vec2 velocity) {
  return {load.force / mass + s.gravity - s.drag * (velocity - cell_motion(s.domain).at(place)), s.integration.rotations ? load.torque / inertia : 0.0};
}

Acceleration acceleration_of(const Sample& s, std::size_t k) {
  const DiskRecord& d = s.record[k];
  if (find_held(s, d.grain)) return {};
  return acceleration_under(s, contact_load(s.list, k), d.mass, inertia(d), d.place, d.velocity);
}

Motion motion_of(const Sample& s, std::size_t k) {
  const Motion own{{s.vx[k], s.vy[k]}, s.omega[k]};
  if (const Integrator& scheme = integrator_of(s); scheme.corrects()) {
    if (!s.settled) return own;
    const Acceleration a = acceleration_of(s, k);
    const double share = 0.5 * scheme.velocity_share * s.dt;
    return {own.velocity + share * (a.linear - Vec2{s.ax[k], s.ay[k]}), own.omega + share * (a.alpha - s.alpha[k])};
  }
  if (s.lag == 0) return own;
  const Acceleration a = acceleration_of(s, k);
  return {own.velocity + s.lag * a.linear, own.omega + s.lag * a.alpha};
}

double time_behind(const Sample& s) {
  if (integrator_of(s).corrects()) return s.settled ? 0.5 * s.dt : 0.0;
  return s.lag;
}

Vec2 velocity_beside(const Sample& s, std::size_t i, std::size_t j, Vec2 image) {
  const CellMotion cell = cell_motion(s.domain);
  return Vec2{s.vx[i], s.vy[i]} + cell.at(s.record[i].place) - Vec2{s.vx[j], s.vy[j]} - cell.at(s.record[j].place) - image;
}

Vec2 place_of(const Sample& s, std::size_t k) {
  const Vec2 place = s.record[k].place;
  const Integrator& scheme = integrator_of(s);
  if (!scheme.corrects() || !s.settled) return place;
  return place + 0.5 * scheme.position_share * s.dt * s.dt * (acceleration_of(s, k).linear - Vec2{s.ax[k], s.ay[k]});
}

double wall_rate(const Sample& s, std::size_t side) {
  const WallBody& body = s.wall[side];
  const double a = wall_acceleration(s, side, s.domain.wall[side].velocity);
  if (const Integrator& scheme = integrator_of(s); scheme.corrects())
    return s.settled ? body.rate + 0.5 * scheme.velocity_share * s.dt * (a - body.acceleration) : body.rate;
  return body.rate + s.lag * a;
}

double wall_place(const Sample& s, std::size_t side) {
  const double place = s.domain.wall[side].position;
  const Integrator& scheme = integrator_of(s);
  if (!scheme.corrects() || !s.settled) return place;
  const double a = wall_acceleration(s, side, s.domain.wall[side].velocity);
  return place + 0.5 * scheme.position_share * s.dt * s.dt * (a - s.wall[side].acceleration);
}

}  // namespace arenite::dem
