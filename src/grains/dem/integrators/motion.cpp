#include "grains/dem/integrators/motion.hpp"

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {

Acceleration acceleration_of(const Sample& s, std::size_t k) {
  if (k < s.count && find_held(s, s.record[k].grain)) return {};
  const Load load = load_on(s, k);
  const Mover m = mover_at(s, k);
  return {load.force / m.mass + s.gravity - s.drag * (m.seen.velocity - cell_motion(s.domain).at(m.place)),
          s.integration.rotations ? load.torque / m.inertia : 0.0};
}

Motion motion_of(const Sample& s, std::size_t k) {
  const Motion own = mover_at(s, k).own;
  const Integrator& scheme = integrator_of(s);
  if (scheme.corrects() ? !s.settled : s.lag == 0) return own;
  const Acceleration a = acceleration_of(s, k);
  if (!scheme.corrects()) return {own.velocity + s.lag * a.linear, own.omega + s.lag * a.alpha};
  const double share = 0.5 * scheme.velocity_share * s.dt;
  return {own.velocity + share * (a.linear - s.acceleration[k]), own.omega + share * (a.alpha - s.alpha[k])};
}

double time_behind(const Sample& s) {
  if (integrator_of(s).corrects()) return s.settled ? 0.5 * s.dt : 0.0;
  return s.lag;
}

Vec2 velocity_beside(const Sample& s, std::size_t i, std::size_t j, Vec2 image) {
  const CellMotion<2> cell = cell_motion(s.domain);
  return s.velocity[i] + cell.at(s.record[i].place) - s.velocity[j] - cell.at(s.record[j].place) - image;
}

Vec2 place_of(const Sample& s, std::size_t k) {
  const Vec2 place = mover_at(s, k).place;
  const Integrator& scheme = integrator_of(s);
  if (!scheme.corrects() || !s.settled) return place;
  return place + 0.5 * scheme.position_share * s.dt * s.dt * (acceleration_of(s, k).linear - s.acceleration[k]);
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
