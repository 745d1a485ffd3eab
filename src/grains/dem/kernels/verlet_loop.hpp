#pragma once
#include "grains/dem/kernels/sweep.hpp"

namespace arenite::dem {

/// One step of velocity Verlet for W disks (integrators/verlet.hpp).
template <int W>
struct VerletBatch {
  ARENITE_INLINE static typename Pack<W>::Bits run(const SweepTask& t, std::size_t k) {
    using V = Pack<W>;
    const MotionPack<W> m(t, k);
    const V kick(t.kick), ahead(t.ahead);
    const V vx = V::load(t.vx + k) + kick * m.ax, vy = V::load(t.vy + k) + kick * m.ay;
    const V omega = V::load(t.omega + k) + kick * m.alpha;
    vx.store(t.vx + k);
    vy.store(t.vy + k);
    omega.store(t.omega + k);
    (V::load(t.angle + k) + V(t.dt) * omega).store(t.angle + k);
    // A way made during the step is carried along by a growing cell for half of it, on average.
    const V x = t.x.moved.apply(m.x) + V(t.dt * (1 + 0.5 * t.x.growth)) * vx;
    const V y = t.y.moved.apply(m.y) + V(t.dt * (1 + 0.5 * t.y.growth)) * vy;
    return place<W>(t, k, m, x, y, vx + ahead * m.ax, vy + ahead * m.ay, omega + ahead * m.alpha);
  }
};

}  // namespace arenite::dem
