#pragma once
#include "dem/sample.hpp"

namespace arenite::dem {

/// Gear's predictor-corrector of fifth order in Nordsieck's scaling, q_k = dt^k/k! d^k x/dt^k, with the coefficients
/// for a second-order equation whose force depends on velocity: 3/16, 251/360, 1, 11/18, 1/6, 1/60.
struct Nordsieck {
  double q0, q1, q2, q3, q4, q5;

  /// `error` = dt^2/2 (a - predicted a).
  void correct(double error) {
    q0 += 3.0 / 16.0 * error;
    q1 += 251.0 / 360.0 * error;
    q2 += error;
    q3 += 11.0 / 18.0 * error;
    q4 += 1.0 / 6.0 * error;
    q5 += 1.0 / 60.0 * error;
  }
  void predict() {
    q0 += q1 + q2 + q3 + q4 + q5;
    q1 += 2 * q2 + 3 * q3 + 4 * q4 + 5 * q5;
    q2 += 3 * q3 + 6 * q4 + 10 * q5;
    q3 += 4 * q4 + 10 * q5;
    q4 += 5 * q5;
  }
};

/// Share of dt^2/2 (a - predicted a) that the correction adds to the position, and of dt/2 (..) to the velocity.
inline constexpr double gear_position_share = 3.0 / 16.0, gear_velocity_share = 251.0 / 360.0;

/// Between steps the sample holds the predicted state at t_n and the forces there. One fused sweep corrects it and
/// predicts t_{n+1}; walls and affine motion too.
void gear_sweep(Sample& sample);

/// Starting values: third to fifth derivatives from forces at the Taylor continuation of the present state half a step
/// and a step ahead and back, three times over. A grain whose contacts change within that span starts with zeros.
/// Expects corrected positions and velocities; leaves forces and springs as of now.
void gear_start(Sample& sample);

}  // namespace arenite::dem
