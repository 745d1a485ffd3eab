#pragma once
#include "grains/dem/integrators/nordsieck.hpp"
#include "grains/dem/kernels/sweep.hpp"

namespace arenite::dem {

/// Corrects one coordinate of W disks and predicts its next values. Returns the way made in the step, from `start` on;
/// `growth` is that of a periodic cell, which carries a way along for what is left of the step.
template <int W>
ARENITE_INLINE Pack<W> correct_and_predict(const SweepTask& t, std::size_t k, std::size_t axis, double* velocity,
                                           double* acceleration, Pack<W> now, Pack<W> start, double growth) {
  using V = Pack<W>;
  const double half = 0.5 * t.dt * t.dt;
  double *const q3 = t.higher[3 * axis] + k, *const q4 = t.higher[3 * axis + 1] + k, *const q5 = t.higher[3 * axis + 2] + k;
  const V predicted = V::load(acceleration + k);
  Nordsieck<V> q{start, V(t.dt) * V::load(velocity + k), V(half) * predicted, V::load(q3), V::load(q4), V::load(q5)};
  q.correct(V(half) * (now - predicted));
  const V carried = V(growth) * q.weighted_way();
  q.predict();
  (V(1.0 / t.dt) * q.q1).store(velocity + k);
  (V(1.0 / half) * q.q2).store(acceleration + k);
  q.q3.store(q3);
  q.q4.store(q4);
  q.q5.store(q5);
  return q.q0 + carried;
}

/// One fused sweep of Gear's method for W disks (integrators/gear.hpp).
template <int W>
struct GearBatch {
  ARENITE_INLINE static typename Pack<W>::Bits run(const SweepTask& t, std::size_t k) {
    using V = Pack<W>;
    const V zero(0.0);
    const MotionPack<W> m(t, k);
    const V way_x = correct_and_predict<W>(t, k, 0, t.vx, t.ax, m.ax, zero, t.x.growth);
    const V way_y = correct_and_predict<W>(t, k, 1, t.vy, t.ay, m.ay, zero, t.y.growth);
    correct_and_predict<W>(t, k, 2, t.omega, t.alpha, m.alpha, V::load(t.angle + k), 0).store(t.angle + k);
    const V x = t.x.moved.apply(m.x) + way_x, y = t.y.moved.apply(m.y) + way_y;
    return place<W>(t, k, m, x, y, V::load(t.vx + k), V::load(t.vy + k), V::load(t.omega + k));
  }
};

}  // namespace arenite::dem
