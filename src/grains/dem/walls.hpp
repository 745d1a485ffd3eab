#pragma once
#include <algorithm>
#include <cmath>

#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Gives force-controlled walls (or edges of a periodic cell) their mass and impedance from the sample.
///
/// A force-controlled wall obeys m q'' = F_target - F_grains - c (q' - w), q its way into the sample, w the slow mean of q', w' = (q' - w)/tau, while
/// another wall is driven by velocity, else 0: what rings is braked, what follows a steady deformation is not, so a sample that is sheared at
/// constant speed feels the target alone. tau is ten passages of a wave, 10 M/Z.
/// A sample of mass M that is as stiff as a crystal of its grains carries waves with the impedance Z = sqrt(K M), K = k W/H: a wall damped by c = Z
/// swallows the waves that reach it, so the sample comes to rest in about one passage instead of ringing. But a loose sample under a small force F
/// yields rather than rings, and then Z would brake it: grains rearrange at speeds of about I sqrt(P/rho) = I sqrt(F H/M), so c is at most F over
/// that speed. I is `inertial_number` of the sample, 0.01 unless a stage says otherwise (measured on laboratory sample 8: a third fewer steps to rest
/// under 100 N; beyond 0.01 a sudden load overshoots by more than a fifth). c is that, times the share of the target that the grains carry already
/// (at most 1): a wall that touches nothing yet is not braked. m is M/20, or a few layers of grains where that is more: light beside the sample,
/// heavy enough that no wall is the stiffest oscillator, so it never limits the time step.
void tune_servo(Sample& sample);

/// Rate of the drag that damps the sample's slowest wave critically, 2 omega with omega = (pi/2) Z/M for a quarter of a wave between a wall that
/// holds and one that presses, Z as in tune_servo, 1/s. Packings are softer than crystals.
double critical_drag(const Sample& sample);

/// Changes the drives: a wall that becomes fixed or velocity-driven takes its velocity at once, one that becomes force-controlled goes on from the
/// velocity that it has.
void apply_drives(Sample& sample, const WallDrives& drives);

/// A wall moves at a given speed: the others have to follow, not to come to rest.
template <int D> bool is_steady(const SampleIn<D>& s) {
  return std::ranges::any_of(s.wall, [](const auto& body) { return body.drive.kind == DriveKind::velocity; });
}

/// c of a force-controlled wall, N s/m.
template <int D> double servo_damping(const SampleIn<D>& s, std::size_t side) {
  const auto& body = s.wall[side];
  const double carried = std::max(s.domain.wall[side].force, 0.0);
  const double share = carried >= body.drive.value ? 1.0 : carried / body.drive.value;
  const double length = s.domain.extent(axis_of(static_cast<int>(side)));
  const double yielding = std::sqrt(std::max(body.drive.value, 0.0) * body.sample_mass / length) / s.inertial_number;
  return std::min(body.impedance, yielding) * share;
}

/// Braking force on a force-controlled wall at this velocity, N along its axis; 0 unless force-controlled.
template <int D> double servo_braking(const SampleIn<D>& s, std::size_t side, double velocity) {
  if (s.wall[side].drive.kind != DriveKind::force) return 0;
  return -servo_damping(s, side) * (velocity - s.wall[side].drift);
}

/// Acceleration of wall `side` from the present forces, m/s^2; 0 unless force-controlled. It and `velocity` are along the wall's axis.
template <int D> double wall_acceleration(const SampleIn<D>& s, std::size_t side, double velocity) {
  const auto& body = s.wall[side];
  if (body.drive.kind != DriveKind::force) return 0;
  const double push = body.drive.value - s.domain.wall[side].force;
  return (inward_sign(side) * push + servo_braking(s, side, velocity)) / body.mass;
}

/// Lets the walls' drift follow their velocity over the step just made.
template <int D> void follow_drift(SampleIn<D>& s) {
  if (!is_steady(s)) return;
  for (int side = 0; side < sides_in<D>; ++side) {
    auto& body = s.wall[side];
    if (body.drive.kind != DriveKind::force) continue;
    const double passages = 10.0 * body.sample_mass / body.impedance;
    body.drift += s.dt / passages * (s.domain.wall[side].velocity - body.drift);
  }
}

}  // namespace arenite::dem
