#pragma once

namespace arenite::dem {

/// Share of dt^2/2 (a - predicted a) that the correction adds to the position, and of dt/2 (..) to the velocity.
inline constexpr double gear_position_share = 3.0 / 16.0, gear_velocity_share = 251.0 / 360.0;

/// Gear's predictor-corrector of fifth order in Nordsieck's scaling, q_k = dt^k/k! d^k x/dt^k, with the coefficients for a second-order equation
/// whose force depends on velocity: 3/16, 251/360, 1, 11/18, 1/6, 1/60. V is a number type.
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

}  // namespace arenite::dem
