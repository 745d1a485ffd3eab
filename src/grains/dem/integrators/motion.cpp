#include "grains/dem/integrators/motion.hpp"

#include "grains/dem/forces.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {

Acceleration acceleration_of(const Sample& s, std::size_t k) {
  if (find_held(s, s.record[k].grain)) return {0, 0, 0};
  const Load load = contact_load(s.list, k);
  const DiskRecord& d = s.record[k];
  const AffineMotion mx = affine_x(s.domain), my = affine_y(s.domain);
  return {load.fx / d.mass + s.gravity.x - s.drag * (d.vx - mx.at(d.x)), load.fy / d.mass + s.gravity.y - s.drag * (d.vy - my.at(d.y)),
          s.integration.rotations ? load.torque / inertia(d) : 0.0};
}

Motion motion_of(const Sample& s, std::size_t k) {
  if (const Integrator& scheme = integrator_of(s); scheme.corrects()) {
    if (!s.settled) return {s.vx[k], s.vy[k], s.omega[k]};
    const Acceleration a = acceleration_of(s, k);
    const double share = 0.5 * scheme.velocity_share * s.dt;
    return {s.vx[k] + share * (a.ax - s.ax[k]), s.vy[k] + share * (a.ay - s.ay[k]), s.omega[k] + share * (a.alpha - s.alpha[k])};
  }
  if (s.lag == 0) return {s.vx[k], s.vy[k], s.omega[k]};
  const Acceleration a = acceleration_of(s, k);
  return {s.vx[k] + s.lag * a.ax, s.vy[k] + s.lag * a.ay, s.omega[k] + s.lag * a.alpha};
}

double time_behind(const Sample& s) {
  if (integrator_of(s).corrects()) return s.settled ? 0.5 * s.dt : 0.0;
  return s.lag;
}

Vec2 velocity_beside(const Sample& s, std::size_t i, std::size_t j, Vec2 image) {
  const AffineMotion mx = affine_x(s.domain), my = affine_y(s.domain);
  return {s.vx[i] + mx.at(s.record[i].x) - s.vx[j] - mx.at(s.record[j].x) - image.x, s.vy[i] + my.at(s.record[i].y) - s.vy[j] - my.at(s.record[j].y) - image.y};
}

Vec2 place_of(const Sample& s, std::size_t k) {
  const Vec2 place{s.record[k].x, s.record[k].y};
  const Integrator& scheme = integrator_of(s);
  if (!scheme.corrects() || !s.settled) return place;
  const Acceleration a = acceleration_of(s, k);
  return place + 0.5 * scheme.position_share * s.dt * s.dt * Vec2{a.ax - s.ax[k], a.ay - s.ay[k]};
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
