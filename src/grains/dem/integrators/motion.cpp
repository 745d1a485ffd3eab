#include "grains/dem/integrators/integrators.hpp"

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {

Acceleration acceleration_of(const Sample& s, std::size_t k) {
  if (k < s.count && find_held(s, s.record[k].grain)) return {};
  const Load load = load_on(s, k);
  const Mover m = mover_at(s, k);
  return {load.force / m.mass + s.gravity - s.drag * (m.seen.velocity - cell_motion(s.domain).at(m.place)),
          s.integration.rotations ? load.torque / m.inertia : 0.0};
}

namespace {

/// What integrated rates and places lack, as so many times the acceleration that a scheme has not foreseen: s and s^2.
struct Behind {
  double rate = 0, place = 0;
};
Behind behind(const Sample& s) {
  const Integrator& scheme = integrator_of(s);
  if (!scheme.corrects()) return {s.lag, 0};
  if (!s.settled) return {};
  return {0.5 * scheme.velocity_share * s.dt, 0.5 * scheme.position_share * s.dt * s.dt};
}

Acceleration unforeseen(const Sample& s, std::size_t k) {
  const Acceleration a = acceleration_of(s, k);
  if (!integrator_of(s).corrects()) return a;
  return {a.linear - s.acceleration[k], a.alpha - s.alpha[k]};
}

double unforeseen_of_wall(const Sample& s, std::size_t side) {
  const double a = wall_acceleration(s, side, s.domain.wall[side].velocity);
  return integrator_of(s).corrects() ? a - s.wall[side].acceleration : a;
}

}  // namespace

Motion motion_of(const Sample& s, std::size_t k) {
  const Motion own = mover_at(s, k).own;
  const double lag = behind(s).rate;
  if (lag == 0) return own;
  const Acceleration a = unforeseen(s, k);
  return {own.velocity + lag * a.linear, own.omega + lag * a.alpha};
}

Vec2 place_of(const Sample& s, std::size_t k) {
  const Vec2 place = mover_at(s, k).place;
  const double lag = behind(s).place;
  return lag == 0 ? place : place + lag * unforeseen(s, k).linear;
}

double wall_rate(const Sample& s, std::size_t side) { return s.wall[side].rate + behind(s).rate * unforeseen_of_wall(s, side); }

double wall_place(const Sample& s, std::size_t side) { return s.domain.wall[side].position + behind(s).place * unforeseen_of_wall(s, side); }

double time_behind(const Sample& s) {
  if (integrator_of(s).corrects()) return s.settled ? 0.5 * s.dt : 0.0;
  return s.lag;
}

Vec2 velocity_beside(const Sample& s, std::size_t i, std::size_t j, Vec2 image) {
  const CellMotion<2> cell = cell_motion(s.domain);
  return s.velocity[i] + cell.at(s.record[i].place) - s.velocity[j] - cell.at(s.record[j].place) - image;
}

}  // namespace arenite::dem
