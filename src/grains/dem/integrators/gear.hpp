#pragma once
#include "grains/dem/integrators/integrator.hpp"

namespace arenite::dem {

/// Share of dt^2/2 (a - predicted a) that the correction adds to the position, and of dt/2 (..) to the velocity.
inline constexpr double gear_position_share = 3.0 / 16.0, gear_velocity_share = 251.0 / 360.0;

/// Gear's predictor-corrector of fifth order in Nordsieck's scaling, q_k = dt^k/k! d^k x/dt^k, with the coefficients
/// for a second-order equation whose force depends on velocity: 3/16, 251/360, 1, 11/18, 1/6, 1/60. V is a number type.
template <class V> struct Nordsieck {
  V q0, q1, q2, q3, q4, q5;

  /// `error` = dt^2/2 (a - predicted a).
  void correct(V error) {
    q0 = q0 + V(gear_position_share) * error;
    q1 = q1 + V(gear_velocity_share) * error;
    q2 = q2 + error;
    q3 = q3 + V(11.0 / 18.0) * error;
    q4 = q4 + V(1.0 / 6.0) * error;
    q5 = q5 + V(1.0 / 60.0) * error;
  }
  void predict() {
    q0 = q0 + (q1 + q2 + q3 + q4 + q5);
    q1 = q1 + (V(2.0) * q2 + V(3.0) * q3 + V(4.0) * q4 + V(5.0) * q5);
    q2 = q2 + (V(3.0) * q3 + V(6.0) * q4 + V(10.0) * q5);
    q3 = q3 + (V(4.0) * q4 + V(10.0) * q5);
    q4 = q4 + V(5.0) * q5;
  }
  /// Mean way of the coming step, weighted by what is left of the step.
  V weighted_way() const { return q1 / V(2.0) + q2 / V(3.0) + q3 / V(4.0) + q4 / V(5.0) + q5 / V(6.0); }
};

/// Corrects one coordinate (of the place or the angle) of W disks or spheres and predicts its next values. Returns the
/// way made in the step, from `start` on; `growth` is that of a periodic cell, which carries a way along for what is
/// left of the step.
template <int W, int D>
ARENITE_INLINE Pack<W> correct_and_predict(const SweepTask<D>& t, std::size_t k, int axis, double* velocity,
                                           double* acceleration, Pack<W> now, Pack<W> start, double growth) {
  using V = Pack<W>;
  const double half = 0.5 * t.dt * t.dt;
  double *const q3 = t.higher[axis][0] + k, *const q4 = t.higher[axis][1] + k, *const q5 = t.higher[axis][2] + k;
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

/// One fused sweep for W disks or spheres: corrects the state at t_n, which was predicted, by the forces there, and
/// predicts t_{n+1}.
template <int W, int D> struct Step<IntegratorKind::gear5, W, D> {
  ARENITE_INLINE static typename Pack<W>::Truths run(const SweepTask<D>& t, std::size_t k) {
    using V = Pack<W>;
    const V zero(0.0);
    const MotionPack<W, D> m(t, k);
    const auto place = by_axis<D>([&](int axis) {
      const Stretch& cell = t.moved[axis];
      return cell.apply(m.place[axis]) + correct_and_predict(t, k, axis, t.velocity[axis], t.acceleration[axis],
                                                             m.acceleration[axis], zero, cell.growth());
    });
    for (int way = 0; way < turnings<D>; ++way) {
      double* const angle = t.angle[way] + k;
      correct_and_predict(t, k, D + way, t.omega[way], t.alpha[way], about(m.alpha, way), V::load(angle), 0)
          .store(angle);
    }
    return put(t, k, m, place, load_columns<W>(t.velocity, k), load_columns<W>(t.omega, k));
  }
};

/// Moves the walls on to the predicted t_{n+1}.
template <int D> void predict_walls(SampleIn<D>& sample, double kick, double ahead);

/// Third to fifth derivatives from forces at the Taylor continuation of the present state half a step and a step ahead
/// and back, three times over. A grain whose contacts change within that span starts with zeros. Leaves forces and
/// springs as of now.
template <int D> void find_derivatives(SampleIn<D>& sample);

/// Between steps the sample holds the predicted state at t_n and the forces there. Bounds of the step are fitted to the
/// eigenvalues of its step; without damping it grows from omega dt = 0.33 on.
inline constexpr Integrator gear5{
    .word = {"gear5", "Gear's fifth-order predictor and corrector; needs small steps where damping is strong"},
    .lag = 0,
    .ahead = 0,
    .lead = 0.5,
    .p = 1.57,
    .q = 1 / 0.163,
    .undamped = 0.33,
    .own = {OwnSteps<2>{predict_walls<2>, find_derivatives<2>}, OwnSteps<3>{predict_walls<3>, find_derivatives<3>}},
    .velocity_share = gear_velocity_share,
    .position_share = gear_position_share,
    .moves_bodies = false};

}  // namespace arenite::dem
